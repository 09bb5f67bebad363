// The four answers of the page as texts: each figure with its interval of sampling, and its ranges over inputs and over
// rock models.

import type { AskedAnswer, EnsembleRange, Interval, LineAnswer, LineQuantity } from '../api/line';
import type { Variation, WhatIfAnswer } from '../api/whatIf';
import { intervalText, percentText } from '../askLine/kit';
import { inputsOf, modelsOf, rangeOver, valueOf, type Range, type SpreadFigure } from '../askLine/spread';
import { nameOf } from '../askLine/tornadoOf';
import { displayOf } from '../state/displayUnits';
import { numberText } from '../units/numbers';
import { modelName, modelText } from './models';

export interface CardFigure {
  /// Empty if the title of the card says it.
  name: string;
  value: string;
  sampling: string;
  /// Null: unknown, such as before the job has begun.
  inputs: string | null;
  models: string | null;
  /// Which inputs give the ends, and what each model gives.
  inputsWhy: string;
  modelsWhy: string;
}
export interface Card {
  key: 'share' | 'energy' | 'height' | 'fence';
  title: string;
  figures: CardFigure[];
  note: string;
}

type Text = (value: number) => string;
interface Scale {
  text: Text;
  /// With "to" between both, the unit once.
  range: (low: number, high: number) => string;
}

const shareScale: Scale = { text: percentText, range: (low, high) => intervalText({ value: 0, low, high }) };
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

/// " (sphere 12 %)": the model that differs most from the run's own; empty if none differs.
function farthestText(models: readonly Variation[], by: SpreadFigure, own: number | null, { text }: Scale): string {
  const known = models.flatMap((model) => ({ model, value: valueOf(model, by) })).filter((each): each is { model: Variation; value: number } => each.value !== null);
  if (own === null || known.length === 0) return '';
  const { model, value } = known.reduce((a, b) => (Math.abs(b.value - own) > Math.abs(a.value - own) ? b : a));
  return text(value) === text(own) ? '' : ` (${modelName(model.model)} ${text(value)})`;
}

const endText = (end: Range['atLow']) => (end ? nameOf(end) : 'the inputs as they are');

function rangesOf(whatIf: WhatIfAnswer | null, by: SpreadFigure, shown: number | null, scale: Scale, isAlone: boolean): Pick<CardFigure, 'inputs' | 'models' | 'inputsWhy' | 'modelsWhy'> {
  if (!whatIf) return { inputs: null, models: null, inputsWhy: '', modelsWhy: '' };
  const { base } = whatIf;
  const [inputs, models] = [inputsOf(whatIf), modelsOf(whatIf)];
  const [overInputs, overModels] = [rangeOver(base, inputs, by, shown), rangeOver(base, models, by, shown)];
  const textOf = (value: number | null) => (value === null ? 'none crosses' : scale.text(value));
  const each = models.map((model) => `${modelText(model)} ${textOf(valueOf(model, by))}`);
  return {
    inputs: overInputs ? scale.range(overInputs.low, overInputs.high) : inputs.length > 0 ? 'none crosses' : null,
    models: overModels ? `${scale.range(overModels.low, overModels.high)}${isAlone ? farthestText(models, by, shown, scale) : ''}` : models.length > 0 ? 'none crosses' : null,
    inputsWhy: overInputs ? `lowest with ${endText(overInputs.atLow)}, highest with ${endText(overInputs.atHigh)}` : '',
    modelsWhy: overModels ? [`${modelName(whatIf.model)} ${textOf(shown ?? valueOf(base, by))} (this run)`, ...each].join(', ') : '',
  };
}

type EnsembleFigure = SpreadFigure & ('share' | LineQuantity | 'needs_energy_J' | 'needs_height_m');
/// Of a run whose parameters are uncertain, its own ensembles tell more of the inputs than steps do.
function overEnsembles(of: AskedAnswer, by: EnsembleFigure, scale: Scale): Pick<CardFigure, 'inputs' | 'inputsWhy'> | null {
  if (!of.ensembles) return null;
  const { ensembles, crossing, confidence } = of.ensembles;
  const range = (of.ensembles as Partial<Record<EnsembleFigure, EnsembleRange | null>>)[by];
  const ofWhich = crossing < ensembles && by !== 'share' ? `${crossing} ensembles with rocks that ${of.kind === 'polygon' ? 'enter' : 'cross'}, of ${ensembles}` : `${ensembles} ensembles`;
  return {
    inputs: range ? scale.range(range[1], range[2]) : 'too few ensembles',
    inputsWhy: `${percentText(confidence)} of the run's ${ofWhich}, each with its own parameters and its own rocks, whose chance is in it`,
  };
}

function figureOf(name: string, value: Interval | null, scale: Scale, of: AskedAnswer, whatIf: WhatIfAnswer | null, by: EnsembleFigure): CardFigure {
  return {
    name,
    value: value ? scale.text(value[0]) : 'none',
    sampling: value ? samplingText(value, scale) : '–',
    ...rangesOf(whatIf, by, value?.[0] ?? null, scale, name === ''),
    ...overEnsembles(of, by, scale),
  };
}

/// The answer of what if applies to the percentile of the cards.
const fitting = (whatIf: WhatIfAnswer | null, percentile: string) => (whatIf && String(whatIf.percentile) === percentile ? whatIf : null);

export const percentileOf = (of: AskedAnswer): string => {
  if (of.kind !== 'polygon') return String(of.design_percentile);
  const known = Object.keys(of.percentiles.ke_total_J ?? {});
  return known.includes('95') ? '95' : (known[0] ?? '95');
};

/// By the standard of [design]; without one the figures as they are. Its ranges are over the fences that the sets need.
function fenceOf(of: LineAnswer, whatIf: WhatIfAnswer | null): Card {
  const { whole, standard } = of;
  const { needs, needs_at_upper_end: upper } = whole;
  const figure = (name: string, scale: Scale, key: 'energy_J' | 'height_m'): CardFigure => ({
    name,
    value: needs ? scale.text(needs[key]) : 'none',
    sampling: upper ? `up to ${scale.text(upper[key])}` : needs ? 'too few rocks' : '–',
    ...rangesOf(whatIf, `needs_${key}`, needs?.[key] ?? null, scale, false),
    ...overEnsembles(of, `needs_${key}`, scale),
  });
  const kit = needs?.class === null ? 'no class is enough' : `class ${needs?.class}`;
  return {
    key: 'fence',
    title: needs && standard !== null ? `Fence needed: ${kit}` : 'Fence needed',
    figures: [figure('energy', scaleOf('J'), 'energy_J'), figure('height', scaleOf('m'), 'height_m')],
    note: standard === null ? 'No standard is chosen: no factors are applied.' : `${standard}, with its factors.`,
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
  const cards: Card[] = [
    {
      key: 'share',
      title: `${isArea ? 'Enters' : 'Passes'} ${placeText}`,
      figures: [figureOf('', share && [share.value, share.low, share.high], shareScale, of, whatIf, 'share')],
      note: `${rocks.toLocaleString('en')} of ${of.run.stored.toLocaleString('en')} rocks`,
    },
    {
      key: 'energy',
      title: `${percentile} % energy there`,
      figures: [
        figureOf('translational', at('ke_translational_J'), energy, of, found, 'ke_translational_J'),
        figureOf('total', at('ke_total_J'), energy, of, found, 'ke_total_J'),
      ],
      note: '',
    },
    {
      key: 'height',
      title: isArea ? `${percentile} % bounce height` : `${percentile} % height of the block's top`,
      figures: [figureOf('', at('height_m'), height, of, found, 'height_m')],
      note: '',
    },
  ];
  return isArea ? cards : [...cards, fenceOf(of, found)];
}
