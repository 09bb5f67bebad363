// Why the answers should not be taken as they are, the most serious reason first, each with what to do.

import { bareWarning } from '../archive/bareWarning';
import type { AskedAnswer, Interval, LineAnswer } from '../api/line';
import type { Summary } from '../api/results';
import type { Problem, ProblemKind } from '../api/types';
import type { Variation, WhatIfAnswer } from '../api/whatIf';
import { percentText } from '../askLine/kit';
import { modelsOf, type IntervalFigure } from '../askLine/spread';
import { displayOf } from '../state/displayUnits';
import { numberText } from '../units/numbers';
import { percentileOf } from './cards';
import { modelName } from './models';

export type DoubtKind = 'outdated' | 'models' | 'height' | 'ground' | 'left' | 'place' | 'run' | 'job';
export interface Doubt {
  kind: DoubtKind;
  text: string;
  /// What to do, empty if the text says it.
  advice: string;
}

export interface Known {
  answer: AskedAnswer | null;
  whatIf: WhatIfAnswer | null;
  summary: Summary | null;
  isOutdated: boolean;
  /// Whether the title block has a text, which may give the reason for the model.
  hasRemark: boolean;
}

/// What a fence needs, and what passes.
const compared: readonly (readonly IntervalFigure[])[] = [['height_m', 'ke_translational_J', 'ke_total_J'], ['share']];
const zero: Interval = [0, 0, 0];

function figureText(by: IntervalFigure, value: number): string {
  if (by === 'share') return percentText(value);
  const { unit, per } = displayOf(by === 'height_m' ? 'm' : 'J');
  return `${numberText(value / per, 3)} ${unit}`;
}
const titles: Partial<Record<IntervalFigure, string>> = {
  height_m: 'height',
  ke_translational_J: 'translational energy',
  ke_total_J: 'total energy',
};

interface Disagreement {
  by: IntervalFigure;
  own: number;
  other: number;
  model: Variation;
  factor: number;
}

/// The figure, of some, in which another model differs most from the project's own; null: none differs by more than its
/// intervals.
function worstOf(figures: readonly IntervalFigure[], { base, models_disagree: apart, ...answer }: WhatIfAnswer, shown: (by: IntervalFigure) => number | null): Disagreement | null {
  const isApart = ({ model }: Variation, by: IntervalFigure) => apart.some((each) => each.model === model && each.figure === by);
  const found = modelsOf(answer).flatMap((model) =>
    figures.flatMap((by): Disagreement[] => {
      const [own, other] = by === 'share' ? [base.share ?? zero, model.share ?? zero] : [base[by], model[by]];
      if (!own || !other || !isApart(model, by)) return [];
      const [small, large] = [Math.min(own[0], other[0]), Math.max(own[0], other[0])];
      return [{ by, own: shown(by) ?? own[0], other: other[0], model, factor: small > 0 ? large / small : Infinity }];
    }),
  );
  return found.length > 0 ? found.reduce((a, b) => (b.factor > a.factor ? b : a)) : null;
}

/// As the cards have it: of all rocks of the run.
const shownIn = (of: AskedAnswer | null) => (by: IntervalFigure) => {
  if (!of || by === 'energy_J') return null;
  if (by === 'share') return (of.kind === 'polygon' ? of.entering.share : of.whole.share)?.value ?? null;
  return (of.kind === 'polygon' ? of : of.whole).percentiles[by]?.[percentileOf(of)]?.[0] ?? null;
};

function modelDoubt(whatIf: WhatIfAnswer, { answer, hasRemark }: Known): Doubt | null {
  const found = compared.flatMap((figures) => worstOf(figures, whatIf, shownIn(answer)) ?? []);
  if (found.length === 0) return null;
  const texts = found.map(({ by, own, other, model }) => {
    const what = by === 'share' ? 'the share that passes' : `the ${whatIf.percentile} % ${titles[by]}`;
    return `${what} is ${figureText(by, own)} with ${modelName(whatIf.model)} (this run) and ${figureText(by, other)} with ${modelName(model.model)}`;
  });
  return {
    kind: 'models',
    text: `Rock models disagree by more than chance: ${texts.join('; ')}.`,
    advice: hasRemark ? '' : 'Choose the model that suits the blocks and the ground; give the reason as text of the title block, which is on the sheet.',
  };
}

const kinds: Partial<Record<string, DoubtKind>> = {
  mostly_on_ground: 'ground',
  height_below_block: 'height',
  kit_below_block: 'height',
  beyond_ends: 'place',
  models_disagree: 'models',
} satisfies Partial<Record<ProblemKind, DoubtKind>>;
const problemDoubt = (kind: DoubtKind, { what, why, hint, text }: Problem): Doubt => ({
  kind,
  text: what ? `${capital(what)}${why && `: ${why}`}.` : text,
  advice: hint && `${hint}.`,
});
const capital = (text: string) => text.slice(0, 1).toUpperCase() + text.slice(1);
/// "road.toml:31: warning: " of the command line is left out.
export const warningText = (text: string) => capital(bareWarning(text));

const nearZero = 0.05; // m above the ground; less than any block

function heightDoubt(of: LineAnswer): Doubt | null {
  const percentile = percentileOf(of);
  const height = of.whole.percentiles.height_m?.[percentile]?.[0];
  const block = of.whole.largest_block_m;
  if (height === undefined || block === null) return null;
  if (height >= block && height >= nearZero) return null;
  return {
    kind: 'height',
    text: `The ${percentile} % height is ${figureText('height_m', height)}, ${height < nearZero ? 'next to nothing: the rocks arrive rolling or sliding' : `less than the diameter of the largest block that crosses, ${figureText('height_m', block)}`}.`,
    advice: 'A fence must be at least as high as the blocks; if they hardly bounce, look at the roughness of the materials.',
  };
}

interface Warning {
  text: string;
  kind: string;
  where: string;
}
/// The warnings of the run, without those that the answer repeats for its place.
function warningsOf(summary: Summary | null, said: readonly Problem[]): Warning[] {
  const kinds = new Map((summary?.warning_kinds ?? []).map((each) => [Number(each.warning), each]));
  return (summary?.warnings ?? [])
    .map((text, k): Warning => ({ text: warningText(text), kind: kinds.get(k)?.kind ?? '', where: kinds.get(k)?.where ?? '' }))
    .filter(({ kind, where }) => kind === '' || !said.some((one) => one.kind === kind && one.where === where));
}

export function doubtsOf(known: Known): Doubt[] {
  const { answer, whatIf, summary, isOutdated } = known;
  const problems = answer?.problems ?? [];
  const found = problems.map((each) => problemDoubt(kinds[each.kind] ?? 'place', each));
  const of = (kind: DoubtKind) => found.filter((each) => each.kind === kind);
  const ofHeight = of('height');
  const own = answer && answer.kind !== 'polygon' && ofHeight.length === 0 ? heightDoubt(answer) : null;
  const notes = (summary?.notes ?? []).map((note): Doubt => ({ kind: 'left', text: `${capital(note)}.`, advice: 'Extend the terrain, unless it ends behind what is protected.' }));
  const warnings = warningsOf(summary, problems);
  // One about the height at another place is not about this answer.
  const kindOf = ({ kind }: Warning): DoubtKind => (kinds[kind] === 'ground' || kinds[kind] === 'models' ? kinds[kind] : 'run');
  const ofRun = (kind: DoubtKind) => warnings.filter((each) => kindOf(each) === kind).map(({ text }): Doubt => ({ kind, text, advice: '' }));
  const ofModels = whatIf && modelDoubt(whatIf, known);
  return [
    ...(isOutdated ? [{ kind: 'outdated', text: 'These answers are of an earlier version of the project.', advice: 'Compute again.' } as const] : []),
    ...(ofModels ? [ofModels] : []),
    ...ofRun('models'),
    ...ofHeight,
    ...(own ? [own] : []),
    ...of('ground'),
    ...ofRun('ground'),
    ...notes,
    ...of('place'),
    ...ofRun('run'),
  ];
}
