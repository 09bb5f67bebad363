// How far a figure moves over sets of the same rocks: with other inputs, and with other rock models.

import type { Interval, Needs } from '../api/line';
import { modelFactor, type Figures, type Variation, type WhatIfAnswer } from '../api/whatIf';

const needed = { needs_energy_J: 'energy_J', needs_class: 'class', needs_height_m: 'height_m' } as const satisfies Record<string, keyof Needs>;
export type NeededFigure = keyof typeof needed;
/// A figure with an interval, or what a fence needs.
export type IntervalFigure = Exclude<keyof Figures, 'rocks' | 'needs' | 'needs_at_upper_end'>;
export type SpreadFigure = IntervalFigure | NeededFigure;

export interface Range {
  low: number;
  high: number;
  /// Which sets give the ends; null: the project's own values.
  atLow: Variation | null;
  atHigh: Variation | null;
  /// The same with the chance of the rocks of each set: to the outermost ends of their intervals of sampling. Null: the set
  /// at that end has too few rocks for an interval.
  chance: { low: number | null; high: number | null };
}

export const inputsOf = ({ variations }: Pick<WhatIfAnswer, 'variations'>) => variations.filter(({ factor }) => factor !== modelFactor);
export const modelsOf = ({ variations }: Pick<WhatIfAnswer, 'variations'>) => variations.filter(({ factor }) => factor === modelFactor);

export const isNeeded = (by: SpreadFigure): by is NeededFigure => by in needed;

/// What a fence needs, up to what it needs at the upper ends of the intervals.
export function neededInterval({ needs, needs_at_upper_end: upper }: Pick<Figures, 'needs' | 'needs_at_upper_end'>, by: NeededFigure): Interval | null {
  return needs && [needs[needed[by]], null, upper?.[needed[by]] ?? null];
}

/// Of a figure; the share of no rock is 0. Null: no rock crosses.
function intervalOf(figures: Figures, by: SpreadFigure): Interval | null {
  if (isNeeded(by)) return neededInterval(figures, by);
  return figures[by] ?? (by === 'share' ? [0, null, null] : null);
}
export const valueOf = (figures: Figures, by: SpreadFigure): number | null => intervalOf(figures, by)?.[0] ?? null;

/// The range over the project's own values and those of the sets. `shown`: the figure that it stands beside, of all rocks
/// of the run, of which the sets may have fewer. Null: there are no sets, or no rock crosses with any.
export function rangeOver(base: Figures, sets: readonly Variation[], by: SpreadFigure, shown: Interval | null = null): Range | null {
  if (sets.length === 0) return null;
  const own = [shown, intervalOf(base, by)].map((interval) => ({ interval, of: null }));
  const all = [...own, ...sets.map((of) => ({ interval: intervalOf(of, by), of }))].flatMap(({ interval, of }) => (interval ? [{ interval, of }] : []));
  const [first] = all;
  if (!first) return null;
  const low = all.reduce((a, b) => (b.interval[0] < a.interval[0] ? b : a), first);
  const high = all.reduce((a, b) => (b.interval[0] > a.interval[0] ? b : a), first);
  const ends = (k: 1 | 2) => all.flatMap(({ interval }) => interval[k] ?? []);
  const chance = {
    low: low.interval[1] === null ? null : Math.min(...ends(1)),
    high: high.interval[2] === null ? null : Math.max(...ends(2)),
  };
  return { low: low.interval[0], high: high.interval[0], atLow: low.of, atHigh: high.of, chance };
}
