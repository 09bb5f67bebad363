// The page of a sensitivity study: for each result, which input causes how much of it.

import type { ElementaryEffect, SensitivityInput, SensitivityResult, SensitivitySummary, SobolIndices } from '../archive/sensitivity';
import type { IntervalOf } from '../archive/summary';
import type { Group } from '../figures/plot';
import { tornado, type TornadoBar } from '../figures/tornado';
import { embedded } from './data';
import { drawing, element, figure, nameFigures } from './figure';
import { count, displayOf, isNumber, measured, number } from './format';
import { section, showStudy } from './studyPage';
import { table, type BodyCell } from './tables';

const page = embedded<SensitivitySummary>();
const isMorris = page.method === 'morris';
const noise = page.inputs.at(-1); // the seed

const texts = isMorris
  ? {
      method: 'Morris screening',
      axis: 'Effect',
      caption:
        'Bars: mean magnitude of the change of the result over the whole range of an input (μ*), with its confidence ' +
        'interval. Diamonds: mean with sign (μ); to the left, more of the input gives less of the result. Grey: the ' +
        'noise of a finite number of rocks.',
      note:
        'A spread σ as large as μ* shows an effect that depends on the input itself or on other inputs. The order of ' +
        'effects counts, not their digits.',
    }
  : {
      method: 'Sobol indices',
      axis: 'Share of the variance',
      caption:
        'Bars: share of the variance that the input causes alone (first-order index, filled) and with others (total ' +
        'index, outline), with the confidence interval of the total. Grey: the noise of a finite number of rocks.',
      note:
        'The first-order index is the share of the variance that would vanish if the input were known; the total ' +
        'index is the share that would remain if all others were. Their difference is the part of interactions. ' +
        'First-order indices that add up to 1 mean that inputs act one by one.',
    };

/// What one input does to a result.
interface InputEffect {
  input: SensitivityInput;
  effect: ElementaryEffect | SobolIndices;
  size: IntervalOf<number>;
}

// Those with an effect, the largest first.
function ranked({ inputs }: SensitivityResult): InputEffect[] {
  const found = page.inputs.flatMap((input, k): InputEffect[] => {
    const effect = inputs[k];
    if (!effect) return [];
    if ('effect' in effect && effect.effect) return [{ input, effect, size: effect.effect }];
    return 'total' in effect && effect.total ? [{ input, effect, size: effect.total }] : [];
  });
  return found.sort((a, b) => b.size[0] - a.size[0]);
}

const nameOf = (input: SensitivityInput) => (input === noise ? 'which rocks are drawn (seed)' : input.name);
// Of sizes: an effect has the unit of the result, an index has none.
const shownSize = ({ unit }: SensitivityResult) => (isMorris ? displayOf(unit) : { unit: '', per: 1 });
// The second value: the mean of an effect with its sign, or the index of first order.
const secondOf = (effect: InputEffect['effect']) => ('effect' in effect ? effect.mean_effect : effect.first[0]);

function barOf({ input, effect, size: [value, low, high] }: InputEffect, per: number): TornadoBar {
  const second = secondOf(effect) / per;
  return {
    name: nameOf(input),
    quiet: input === noise,
    value: value / per,
    low: isNumber(low) ? low / per : null,
    high: isNumber(high) ? high / per : null,
    inner: isMorris ? null : second,
    mark: isMorris ? second : null,
  };
}

function tornadoFigure(parent: Group, result: SensitivityResult) {
  const effects = ranked(result);
  const { unit, per } = shownSize(result);
  const bars = effects.map((each) => barOf(each, per));
  figure(parent, {
    title: result.title,
    width: drawing.wide,
    tall: 74 + 30 * bars.length,
    label: `Effects of ${bars.length} inputs on ${result.title}`,
    caption: texts.caption,
    fill: (node, room) => tornado(node, room, { title: texts.axis, unit, per: 1, bars }),
    rows: () => [
      ['input', 'size', 'low', 'high', isMorris ? 'mean_effect' : 'first'],
      ...effects.map(({ input, effect, size }) => [input.name, ...size, secondOf(effect)]),
    ],
  });
}

function effectsTable(parent: Group, result: SensitivityResult) {
  const { unit, per } = shownSize(result);
  const text = (value: number) => measured(value / per, 3);
  const cell = ([value, low, high]: IntervalOf<number>): BodyCell => ({
    text: text(value),
    below: isNumber(low) && isNumber(high) ? `${text(low)} to ${text(high)}` : null,
  });
  const cells = (effect: InputEffect['effect']) =>
    'effect' in effect
      ? [cell(effect.effect), text(effect.mean_effect), text(effect.spread)]
      : [cell(effect.total), cell(effect.first)];
  const heads = isMorris
    ? ['Effect μ*', 'Mean μ', 'Spread σ'].map((head) => ({ text: head, unit }))
    : ['Total index', 'First-order index'];
  table(parent, {
    caption: `Effects on ${result.title}; below each the ${number(100 * page.confidence)} % confidence interval`,
    head: [['Input', 'Values', ...heads]],
    rows: ranked(result).map(({ effect, input }) => [
      nameOf(input),
      `${input.values}${input.unit ? ` ${input.unit}` : ''}`,
      ...cells(effect),
    ]),
    numeric: (column) => column > 1,
  });
}

function resultText({ unit: unitOfData, runs, mean, least, most }: SensitivityResult): string {
  if (runs === 0) return 'No run has a value.';
  const { unit, per } = displayOf(unitOfData);
  const text = (value: number | null) => measured(value === null ? null : value / per, 4);
  return `Over ${count(runs, 'run')}: mean ${text(mean)}, from ${text(least)} to ${text(most)}${unit ? ` ${unit}` : ''}.`;
}

function showResult(node: Group, result: SensitivityResult) {
  element(node, 'p', resultText(result));
  if (ranked(result).length === 0) return;
  tornadoFigure(node, result);
  effectsTable(node, result);
}

const isAtSeveral = page.sites.length > 1;
const siteTexts = page.sites.map(({ name, project }) => (isAtSeveral ? `${name} (${project})` : project));
const capitalized = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

nameFigures(page.name);
showStudy({
  kind: 'Sensitivity of a rockfall analysis',
  title: page.name,
  facts: [
    [isAtSeveral ? 'Sites ' : 'Project ', siteTexts.join(', ')],
    ['Method ', texts.method],
    ['Runs ', number(page.runs)],
    ['Rocks each ', number(page.rocks)],
    ['Seed ', String(page.seed)],
    ['Talus ', page.talus.version],
  ],
  version: page.talus.version,
  warnings: page.warnings,
  metric: 'Values of inputs',
  show: (main) => {
    page.results.forEach((result, k) =>
      section(main, capitalized(result.title), `result-${k}`, (node) => showResult(node, result)),
    );
    element(main, 'p', texts.note, { class: 'quiet' });
  },
});
