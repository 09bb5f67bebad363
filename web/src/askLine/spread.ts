// How far a figure moves over sets of the same rocks: with other inputs, and with other rock models.

import { modelFactor, type Figures, type Variation, type WhatIfAnswer } from '../api/whatIf';

/// A figure with an interval, or what a fence needs.
export type IntervalFigure = Exclude<keyof Figures, 'rocks' | 'needs'>;
export type SpreadFigure = IntervalFigure | 'needs_energy_J' | 'needs_height_m';

export interface Range {
  low: number;
  high: number;
  /// Which sets give the ends; null: the project's own values.
  atLow: Variation | null;
  atHigh: Variation | null;
}

export const inputsOf = ({ variations }: Pick<WhatIfAnswer, 'variations'>) => variations.filter(({ factor }) => factor !== modelFactor);
export const modelsOf = ({ variations }: Pick<WhatIfAnswer, 'variations'>) => variations.filter(({ factor }) => factor === modelFactor);

/// Of a figure; the share of no rock is 0. Null: no rock crosses.
export function valueOf(figures: Figures, by: SpreadFigure): number | null {
  if (by === 'needs_energy_J') return figures.needs?.energy_J ?? null;
  if (by === 'needs_height_m') return figures.needs?.height_m ?? null;
  return figures[by]?.[0] ?? (by === 'share' ? 0 : null);
}

/// The range over the project's own values and those of the sets. `shown`: the figure that it stands beside, of all rocks
/// of the run, of which the sets may have fewer. Null: there are no sets, or no rock crosses with any.
export function rangeOver(base: Figures, sets: readonly Variation[], by: SpreadFigure, shown: number | null = null): Range | null {
  if (sets.length === 0) return null;
  const own = [shown, valueOf(base, by)].map((value) => ({ value, of: null }));
  const all = [...own, ...sets.map((of) => ({ value: valueOf(of, by), of }))].flatMap(({ value, of }) => (value === null ? [] : { value, of }));
  if (all.length === 0) return null;
  const low = all.reduce((a, b) => (b.value < a.value ? b : a));
  const high = all.reduce((a, b) => (b.value > a.value ? b : a));
  return { low: low.value, high: high.value, atLow: low.of, atHigh: high.of };
}
