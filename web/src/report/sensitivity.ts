// The page of a sensitivity study: for each result, which input causes how much of it.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';
import { drawing, element, figure, unitChoice, unitNote } from './figure';
import { count, displayOf, isNumber, measured, number } from './format';
import { fitTablesToPaper } from './paper';
import { page } from './study';
import { table } from './tables';

const isMorris = page.method === 'morris';
const noise = page.inputs.length - 1;  // the seed, the last input
const sizeOf = (effect) => (isMorris ? effect.effect : effect.total) || null;
const shownIn = (result) => displayOf(result.unit);
const nameOf = (input) => input === page.inputs[noise] ? 'which rocks are drawn (seed)' : input.name;

// Inputs by the size of their effect, the largest first.
const ranked = (result) => result.inputs.map((effect, k) => ({effect, k, input: page.inputs[k], size: sizeOf(effect)}))
  .filter(({size}) => size).sort((a, b) => b.size[0] - a.size[0]);

function tornadoFigure(parent, result) {
  const rows = ranked(result);
  const {unit, per} = isMorris ? shownIn(result) : {unit: '', per: 1};
  const bars = rows.map(({effect, k, input, size}) => ({
    name: nameOf(input), quiet: k === noise, value: size[0] / per, low: isNumber(size[1]) ? size[1] / per : null, high: isNumber(size[2]) ? size[2] / per : null,
    inner: isMorris ? null : effect.first[0], mark: isMorris ? effect.mean_effect / per : null,
  }));
  figure(parent, {
    title: result.title, width: drawing.wide, tall: 74 + 30 * bars.length,
    label: `Effects of ${bars.length} inputs on ${result.title}`,
    caption: isMorris ? 'Bars: mean magnitude of the change of the result over the whole range of an input (μ*), with its confidence interval. Diamonds: mean with sign (μ); to the left, more of the input gives less of the result. Grey: the noise of a finite number of rocks.'
      : 'Bars: share of the variance that the input causes alone (first-order index, filled) and with others (total index, outline), with the confidence interval of the total. Grey: the noise of a finite number of rocks.',
    fill: (node, room) => figures.tornado(node, room, {title: isMorris ? 'Effect' : 'Share of the variance', unit, per: 1, bars}),
    rows: () => [['input', 'size', 'low', 'high', isMorris ? 'mean_effect' : 'first'], ...rows.map(({effect, input, size}) => [input.name, ...size, isMorris ? effect.mean_effect : effect.first[0]])],
  });
}

function effectsTable(parent, result) {
  const {unit, per} = isMorris ? shownIn(result) : {unit: '', per: 1};
  const cell = ([value, low, high]) => ({text: measured(value / per, 3), below: isNumber(low) && isNumber(high) ? `${measured(low / per, 3)} to ${measured(high / per, 3)}` : undefined});
  table(parent, {
    caption: `Effects on ${result.title}; below each the ${number(100 * page.confidence)} % confidence interval`,
    head: [['Input', 'Values', ...(isMorris ? [{text: 'Effect μ*', unit}, {text: 'Mean μ', unit}, {text: 'Spread σ', unit}] : ['Total index', 'First-order index'])]],
    rows: ranked(result).map(({effect, input}) => [nameOf(input), `${input.values}${input.unit ? ` ${input.unit}` : ''}`,
      ...(isMorris ? [cell(effect.effect), measured(effect.mean_effect / per, 3), measured(effect.spread / per, 3)] : [cell(effect.total), cell(effect.first)])]),
    numeric: (column) => column > 1,
  });
}

function resultText(result) {
  const {unit, per} = shownIn(result), text = (value) => isNumber(value) ? measured(value / per, 4) : '–';
  if (!result.runs) return 'No run has a value.';
  return `Over ${count(result.runs, 'run')}: mean ${text(result.mean)}, from ${text(result.least)} to ${text(result.most)}${unit ? ` ${unit}` : ''}.`;
}

// Draws the page, or draws it again in other units.
function show() {
  for (const part of ['#head', '#contents', '#main', '#foot']) d3.select(part).selectAll('*').remove();
  const head = d3.select('#head');
  unitChoice(head, show);
  element(head, 'p', 'Sensitivity of a rockfall analysis', {class: 'kind'});
  element(head, 'h1', page.name);
  const facts = element(head, 'p', null, {class: 'facts'});
  const method = isMorris ? 'Morris screening' : 'Sobol indices';
  [[page.sites.length > 1 ? 'Sites ' : 'Project ', page.sites.map((site) => page.sites.length > 1 ? `${site.name} (${site.project})` : site.project).join(', ')], ['Method ', method], ['Runs ', number(page.runs)], ['Rocks each ', number(page.rocks)], ['Seed ', String(page.seed)], ['Talus ', page.talus.version]]
    .forEach(([label, value], i) => {
      facts.append('span').text((i ? '  ·  ' : '') + label);
      element(facts, 'b', value);
    });
  unitNote(head, 'Values of inputs');
  const main = d3.select('#main');
  if (page.warnings.length) {
    const box = element(main, 'section', null, {class: 'warnings', 'aria-label': 'Warnings'});
    element(box, 'h2', 'Warnings');
    const list = element(box, 'ul');
    for (const warning of page.warnings) element(list, 'li', warning);
  }
  page.results.forEach((result, k) => {
    const node = element(main, 'section', null, {id: `result-${k}`, 'aria-label': result.title});
    element(node, 'h2', result.title.charAt(0).toUpperCase() + result.title.slice(1));
    element(node, 'p', resultText(result));
    if (ranked(result).length) {
      tornadoFigure(node, result);
      effectsTable(node, result);
    }
    element(d3.select('#contents'), 'a', result.title, {href: `#result-${k}`});
  });
  element(main, 'p', isMorris ? 'A spread σ as large as μ* shows an effect that depends on the input itself or on other inputs. The order of effects counts, not their digits.'
    : 'The first-order index is the share of the variance that would vanish if the input were known; the total index is the share that would remain if all others were. Their difference is the part of interactions. First-order indices that add up to 1 mean that inputs act one by one.', {class: 'quiet'});
  fitTablesToPaper();
  element(d3.select('#foot'), 'p', `Generated by Talus ${page.talus.version}. This page needs no network. Drawn with D3 (d3js.org), copyright Mike Bostock.`);
}

show();
