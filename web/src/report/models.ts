// The page of a comparison of rock models: figures of each side by side, and the same rocks under all.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';
import { drawing, element, figure, unitChoice, unitNote } from './figure';
import { amountIn, count, displayOf, isNumber, measured, number, unitIn } from './format';
import { fitTablesToPaper } from './paper';
import { page } from './study';
import { table } from './tables';

const sets = [{...page.base, model: page.model}, ...page.variations];
const isAsked = page.place !== '';
const modelName = ({model}) => figures.modelNames[model] + (model === page.model ? ' (the project’s)' : '');
const shapeOf = ({changes}) => [...new Set((changes || []).filter(({path}) => path[2] === 'shape').map(({after}) => after))].join(', ');

const percentText = (share) => `${measured(100 * share, 3)} %`;
const inShown = (unit) => (value) => `${measured(amountIn(unit, value), 3)} ${unitIn(unit)}`;
const p = `${number(page.percentile)} %`;
const rowsOfFigures = [
  ...(isAsked ? [
    {title: page.is_line ? 'Cross' : 'Enter', key: 'share', text: percentText},
    {title: `${p} translational energy`, key: 'ke_translational_J', text: inShown('J')},
    {title: `${p} total energy`, key: 'ke_total_J', text: inShown('J')},
    {title: `${p} ${page.is_line ? 'height of the block’s top' : 'bounce height'}`, key: 'height_m', text: inShown('m')},
    {title: `${p} velocity`, key: 'velocity_m_s', text: inShown('m/s')},
  ] : []),
  {title: 'Median runout on plan', key: 'runout_median_m', text: inShown('m')},
  {title: `${p} runout on plan`, key: 'runout_m', text: inShown('m')},
  {title: 'Leave the model', key: 'left', text: percentText},
];

function figuresTable(parent) {
  const cell = (set, {key, text}) => {
    const [value, low, high] = set[key] || [null, null, null];
    return value === null ? '–' : {text: text(value), below: isNumber(low) && isNumber(high) ? `${text(low)} to ${text(high)}` : undefined};
  };
  table(parent, {
    caption: `The same ${count(page.rocks, 'rock')} with each model; below each figure its ${number(100 * page.confidence)} % confidence interval, of sampling alone`,
    head: [['Figure', ...sets.map((set) => modelName(set) + (shapeOf(set) ? `, shape ${shapeOf(set)}` : ''))]],
    rows: rowsOfFigures.map((row) => [row.title, ...sets.map((set) => cell(set, row))]),
    numeric: (column) => column > 0,
  });
}

function paths(parent) {
  const view = page.side_view, {unit, per} = displayOf('m');
  const {s, z} = figures.rangesOf(view);
  const tall = Math.min(460, Math.max(190, 120 + 370 * (z[1] - z[0]) / Math.max(s[1] - s[0], 1e-9)));
  figure(parent, {
    title: 'How far rocks go', width: drawing.wide, tall: 250,
    caption: 'The share of all rocks that go at least so far from their release, under each model.',
    fill: (node, room) => figures.reach(node, room, {of: view, unit, per}),
    rows: () => [['model', 'runout_m'], ...view.sets.flatMap(({model, runout_m}) => runout_m.map((runout) => [model, runout]))],
  });
  const columns = element(parent, 'div', null, {class: 'columns'});
  view.sets.forEach((set, which) => figure(columns, {
    title: modelName(set), tall, label: `Paths of ${set.paths.length} rocks, ${modelName(set)}`,
    fill: (node, room) => figures.sideView(node, room, {of: view, which, unit, per}),
  }));
}

// Draws the page, or draws it again in other units.
function show() {
  for (const part of ['#head', '#contents', '#main', '#foot']) d3.select(part).selectAll('*').remove();
  const head = d3.select('#head');
  unitChoice(head, show);
  element(head, 'p', 'Rock models compared', {class: 'kind'});
  element(head, 'h1', page.name || page.project);
  const facts = element(head, 'p', null, {class: 'facts'});
  [['Project ', page.project], ['At ', isAsked ? page.place : 'no place: only how far rocks go'], ['Rocks ', number(page.rocks)], ['Seed ', String(page.seed)], ['Talus ', page.talus.version]]
    .forEach(([label, value], i) => {
      facts.append('span').text((i ? '  ·  ' : '') + label);
      element(facts, 'b', value);
    });
  unitNote(head, 'Sentences about models');
  const main = d3.select('#main');
  const list = (title, texts) => {
    if (!texts.length) return;
    const box = element(main, 'section', null, {class: 'warnings', 'aria-label': title});
    element(box, 'h2', title);
    const items = element(box, 'ul');
    for (const text of texts) element(items, 'li', text);
  };
  list('The models differ by more than chance', page.disagreements);
  list('Warnings', page.warnings);
  const section = (id, title) => {
    const node = element(main, 'section', null, {id, 'aria-label': title});
    element(node, 'h2', title);
    element(d3.select('#contents'), 'a', title, {href: `#${id}`});
    return node;
  };
  figuresTable(section('figures', 'Figures'));
  if (page.side_view) paths(section('paths', 'The same rocks under each model'));
  element(main, 'p', 'No model is right by itself. Choose by observed rocks, or take the worst of the models that cannot be ruled out.', {class: 'quiet'});
  fitTablesToPaper();
  element(d3.select('#foot'), 'p', `Generated by Talus ${page.talus.version}. This page needs no network. Drawn with D3 (d3js.org), copyright Mike Bostock.`);
}

show();
