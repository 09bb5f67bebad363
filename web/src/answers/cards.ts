// The four answers of the page as texts: each figure with its interval of sampling, and its ranges over inputs and over
// rock models.

import type { AskedAnswer, EnsembleRange, Interval, LineAnswer, LineQuantity } from '../api/line';
import type { WhatIfAnswer } from '../api/whatIf';
import { intervalText, percentText } from '../askLine/kit';
import { inputsOf, isNeeded, modelsOf, neededInterval, rangeOver, valueOf, type NeededFigure, type Range, type SpreadFigure } from '../askLine/spread';
import { nameOf } from '../askLine/tornadoOf';
import { mostNeeded, mostNeededText } from '../askLine/stretches';
import { displayOf } from '../state/displayUnits';
import { numberText } from '../units/numbers';
import { modelName, modelText } from './models';

/// How far a figure moves over sets of rocks.
export interface CardRange {
  text: string;
  /// The same with the chance of the rocks of the sets; empty: it is in the text, or there is nothing to say.
  withChance: string;
  /// Which inputs give the ends, or what each model gives.
  why: string;
}
export interface CardFigure {
  /// Empty if the title of the card says it.
  name: string;
  value: string;
  sampling: string;
  /// The most that a stretch of the line needs by itself; empty: there are none.
  stretches: string;
  /// Null: unknown, such as before the job has begun.
  inputs: CardRange | null;
  models: CardRange | null;
}
export interface Card {
  key: 'share' | 'energy' | 'height' | 'fence';
  title: string;
  figures: CardFigure[];
  notes: string[];
  /// On paper alone.
  printed: string[];
}

type Text = (value: number) => string;
interface Scale {
  text: Text;
  /// With "to" between both, the unit once.
  range: (low: number, high: number) => string;
}

const shareScale: Scale = { text: percentText, range: (low, high) => intervalText({ value: 0, low, high }) };
const classScale: Scale = { text: String, range: (low, high) => `${low} to ${high}` };
function scaleOf(metric: string): Scale {
  const { unit, per } = displayOf(metric);
  const number = (value: number) => numberText(value / per, 3);
  return { text: (value) => `${number(value)} ${unit}`, range: (low, high) => `${number(low)} to ${number(high)} ${unit}` };
}

/// "1.2 to 3.4 m"; "1.2 m or more" with too few rocks.
export function samplingText([, low, high]: Interval, { text, range }: Scale): string {
  if (low !== null && high !== null) return range(low, high);
  return low !== null ? `${text(low)} or more` : high !== null ? `up to ${text(high)}` : 'too few rocks';
}

const endText = (end: Range['atLow']) => (end ? nameOf(end) : 'the inputs as they are');
const nothing: CardRange = { text: 'none crosses', withChance: '', why: '' };

function textOf({ low, high, chance }: Range, scale: Scale): Pick<CardRange, 'text' | 'withChance'> {
  const [least, most] = [scale.text(low), scale.text(high)];
  return {
    text: least === most ? `${least} in each` : scale.range(low, high),
    withChance: samplingText([low, chance.low, chance.high], scale),
  };
}

interface Shown {
  by: EnsembleFigure;
  /// Of all rocks of the run.
  value: Interval | null;
  scale: Scale;
}

function overInputs(whatIf: WhatIfAnswer, { by, value, scale }: Shown): CardRange | null {
  const sets = inputsOf(whatIf);
  if (sets.length === 0) return null;
  const range = rangeOver(whatIf.base, sets, by, value);
  return range ? { ...textOf(range, scale), why: `lowest with ${endText(range.atLow)}, highest with ${endText(range.atHigh)}` } : nothing;
}

function overModels(whatIf: WhatIfAnswer, { by, value, scale }: Shown): CardRange | null {
  const sets = modelsOf(whatIf);
  if (sets.length === 0) return null;
  const range = rangeOver(whatIf.base, sets, by, value);
  if (!range) return nothing;
  const own = value?.[0] ?? null;
  const valueText = (of: number | null) => (of === null ? 'none crosses' : scale.text(of));
  return {
    ...textOf(range, scale),
    why: [`${modelName(whatIf.model)} ${valueText(own ?? valueOf(whatIf.base, by))} (this run)`, ...sets.map((model) => `${modelText(model)} ${valueText(valueOf(model, by))}`)].join(', '),
  };
}

type EnsembleFigure = SpreadFigure & ('share' | LineQuantity | NeededFigure);
/// Of a run whose parameters are uncertain, its own ensembles tell more of the inputs than steps do.
function overEnsembles(of: AskedAnswer, { by, scale }: Shown): CardRange | null {
  if (!of.ensembles) return null;
  const { ensembles, crossing, confidence } = of.ensembles;
  const range = (of.ensembles as Partial<Record<EnsembleFigure, EnsembleRange | null>>)[by];
  const ofWhich = crossing < ensembles && by !== 'share' ? `${crossing} ensembles with rocks that ${of.kind === 'polygon' ? 'enter' : 'cross'}, of ${ensembles}` : `${ensembles} ensembles`;
  return {
    text: range ? scale.range(range[1], range[2]) : 'too few ensembles',
    withChance: '',
    why: `${percentText(confidence)} of the run's ${ofWhich}, each with its own parameters and its own rocks, whose chance is in it`,
  };
}

function figureOf(name: string, shown: Shown, of: AskedAnswer, whatIf: WhatIfAnswer | null): CardFigure {
  const { value, scale, by } = shown;
  const stretches = of.kind !== 'polygon' && isNeeded(by) ? mostNeeded(of).map(({ stretch }) => neededInterval(stretch, by)![0]) : [];
  return {
    name,
    value: value ? scale.text(value[0]) : 'none',
    sampling: value ? samplingText(value, scale) : '–',
    stretches: stretches.length > 0 ? `up to ${scale.text(Math.max(...stretches))}` : '',
    inputs: overEnsembles(of, shown) ?? (whatIf && overInputs(whatIf, shown)),
    models: whatIf && overModels(whatIf, shown),
  };
}

/// The answer of what if applies to the percentile of the cards.
const fitting = (whatIf: WhatIfAnswer | null, percentile: string) => (whatIf && String(whatIf.percentile) === percentile ? whatIf : null);

export const percentileOf = (of: AskedAnswer): string => {
  if (of.kind !== 'polygon') return String(of.design_percentile);
  const known = Object.keys(of.percentiles.ke_total_J ?? {});
  return known.includes('95') ? '95' : (known[0] ?? '95');
};

/// "By UNI 11211-4 at MEL, with γ_Tr 1.1, γ_E 1.2; total energies as simulated, without a design block."
function checkText({ standard, applied_factors: applied, factors }: LineAnswer): string {
  if (standard === null) return 'No standard is chosen: no factors are applied.';
  const known = applied.filter(({ value }) => value !== 1).map(({ symbol, value }) => `${symbol} ${numberText(value)}`);
  const { unit, per } = displayOf('kg');
  const energies = factors.block_mass_kg === null ? `${factors.of_total_energy ? 'total' : 'translational'} energies as simulated, without a design block` : `velocities with a design block of ${numberText(factors.block_mass_kg / per)} ${unit}`;
  return `By ${standard} at ${factors.level}${known.length > 0 ? `, with ${known.join(', ')}` : ''}; ${energies}.`;
}

const byModels = (title: string, { models }: CardFigure) => (models?.why ? [`${title}: ${models.why}.`] : []);

/// By the standard of [design]; without one the figures as they are. Its ranges are over the fences that the sets need.
function fenceOf(of: LineAnswer, whatIf: WhatIfAnswer | null): Card {
  const { whole, standard } = of;
  const figure = (name: string, scale: Scale, by: NeededFigure) => figureOf(name, { by, value: neededInterval(whole, by), scale }, of, whatIf);
  const most = mostNeeded(of);
  const ofClass = standard === null ? [] : [figure('class', classScale, 'needs_class')];
  return {
    key: 'fence',
    title: most.length > 0 ? 'Fence needed, whole line' : 'Fence needed',
    figures: [...ofClass, figure('energy', scaleOf('J'), 'needs_energy_J'), figure('height', scaleOf('m'), 'needs_height_m')],
    notes: most.length > 0 ? [`By stretches, red: ${mostNeededText(most)} along the line. A fence that is the same all along needs the most of them.`] : [],
    printed: [...ofClass.flatMap((each) => byModels('Class by models', each)), checkText(of)],
  };
}

export function cardsOf(of: AskedAnswer, whatIf: WhatIfAnswer | null, placeText: string): Card[] {
  const percentile = percentileOf(of);
  const found = fitting(whatIf, percentile);
  const isArea = of.kind === 'polygon';
  const share = isArea ? of.entering.share : of.whole.share;
  const percentiles = isArea ? of.percentiles : of.whole.percentiles;
  const rocks = isArea ? of.entering.rocks : of.whole.rocks;
  const at = (key: LineQuantity) => percentiles[key]?.[percentile] ?? null;
  const [energy, height] = [scaleOf('J'), scaleOf('m')];
  const figure = (name: string, by: LineQuantity, scale: Scale) => figureOf(name, { by, value: at(by), scale }, of, found);
  const passing = figureOf('', { by: 'share', value: share && [share.value, share.low, share.high], scale: shareScale }, of, whatIf);
  const energies = [figure('translational', 'ke_translational_J', energy), figure('total', 'ke_total_J', energy)];
  const top = figure('', 'height_m', height);
  const cards: Card[] = [
    {
      key: 'share',
      title: `${isArea ? 'Enters' : 'Passes'} ${placeText}`,
      figures: [passing],
      notes: [`${rocks.toLocaleString('en')} of ${of.run.stored.toLocaleString('en')} rocks.`, ...byModels('By models', passing)],
      printed: [],
    },
    { key: 'energy', title: `${percentile} % energy there`, figures: energies, notes: [], printed: isArea || of.factors.of_total_energy ? byModels('Total by models', energies[1]!) : byModels('Translational by models', energies[0]!) },
    { key: 'height', title: isArea ? `${percentile} % bounce height` : `${percentile} % height of the block's top`, figures: [top], notes: byModels('By models', top), printed: [] },
  ];
  return isArea ? cards : [...cards, fenceOf(of, found)];
}
