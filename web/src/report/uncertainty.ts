// Figures of a run with uncertain parameters: the range between ensembles, and the parts of rocks and of parameters.

import { figureTitle, type FigureUncertainty, type RangeOf } from '../archive/uncertainty';
import * as d3 from '../figures/d3';
import { axes, legend, sign, type Group } from '../figures/plot';
import { tip } from '../figures/tip';
import { shortened } from '../figures/tornado';
import { figureUnit } from './convergence';
import { drawing, element, figure } from './figure';
import { count, measured, number, settingText } from './format';
import { runs, single, tableOf, type Run } from './run';
import { table, type Row } from './tables';

function uncertaintyRow(each: FigureUncertainty): Row {
  const { unit, per } = figureUnit(each);
  const range = ([, low, high]: RangeOf) => `${measured(low / per, 4)} to ${measured(high / per, 4)}`;
  return [
    figureTitle(each),
    `${measured(each.total[0] / per, 4)} ${unit}`,
    range(each.total),
    each.parameter_share > 0 ? range(each.parameters) : '–',
    range(each.rocks),
    `${number(Math.round(100 * each.parameter_share))} %`,
  ];
}

function uncertaintyTable(parent: Group, { uncertainty, label }: Run) {
  const { figures, confidence, ensembles } = uncertainty;
  const ranges = `${number(100 * confidence)} % ranges over ${count(ensembles, 'ensemble')}`;
  table(parent, {
    caption: `Figures with their ${ranges}${single ? '' : ` · ${label}`}`,
    head: [
      [
        ...['Figure', 'All rocks', 'Range between ensembles'],
        ...['Of the parameters alone', 'Of the rocks alone', 'Part of the parameters'],
      ],
    ],
    rows: figures.map(uncertaintyRow),
    numeric: (column) => column > 0,
  });
}

const letterWidth = 6.4;
const rowHeight = 24;
const colours = { parameters: 'var(--m3)', rocks: 'var(--m1)' };

// Which part of each figure's variance between ensembles is due to the parameters, and which to the rocks.
function drawParts(svg: Group, width: number, shown: readonly FigureUncertainty[]): number {
  const longest = Math.max(...shown.map((each) => figureTitle(each).length));
  const names = Math.min(0.5 * width, letterWidth * longest);
  const [left, right, top] = [24 + names, width - 14, 30];
  const bottom = top + rowHeight * shown.length;
  const x = d3.scaleLinear().domain([0, 100]).range([left, right]);
  axes(svg, x, null, { left, right, top, bottom }, { xLabel: 'Part of the variance between ensembles [%]', yLabel: '' });
  shown.forEach((each, k) => {
    const g: Group = svg.append('g');
    const y = top + rowHeight * k + 4;
    const share = 100 * each.parameter_share;
    const title = figureTitle(each);
    g.append('text')
      .attr('x', left - 10)
      .attr('y', y + 12)
      .attr('text-anchor', 'end')
      .text(shortened(title, names));
    const bar = (from: number, to: number, colour: string) =>
      g
        .append('rect')
        .attr('class', 'bar')
        .style('--run', colour)
        .attr('x', from)
        .attr('width', to - from)
        .attr('y', y)
        .attr('height', rowHeight - 8);
    bar(left, x(share), colours.parameters);
    bar(x(share), right, colours.rocks);
    tip(g, () => `${title}\nparameters ${number(Math.round(share))} %, rocks ${number(Math.round(100 - share))} %`);
  });
  const entries = Object.entries(colours).map(([text, colour]) => ({ text, draw: sign.box('bar', colour) }));
  legend(svg, entries, left, 12, right);
  return bottom + 44;
}

function uncertaintyFigure(parent: Group, { uncertainty: { figures }, label }: Run) {
  figure(parent, {
    title: single ? 'Parts of the uncertainty' : `Parts of the uncertainty · ${label}`,
    label: 'Parts of parameters and of rocks in the variance of each figure between ensembles',
    caption: '',
    width: drawing.wide,
    draw: (svg, width) => drawParts(svg, width, figures),
    rows: () => [
      ['figure', 'parameters', 'rocks'],
      ...figures.map((each) => [figureTitle(each), each.parameter_share, 1 - each.parameter_share]),
    ],
  });
}

function ensemblesText(run: Run): string {
  const { ensembles } = run.uncertainty;
  const rocks = Math.round((run.summary.rocks.planned || 0) / ensembles);
  const file = settingText(tableOf(run, 'sampling').parameters);
  return (
    `The rocks of this run belong to ${count(ensembles, 'ensemble')} of about ${count(rocks, 'rock')}, each with parameters ` +
    `drawn from ${file}. All other sections of this page are of all rocks together, but for maps and curves of a range ` +
    'between ensembles: their percentiles contain the uncertainty of the parameters. The table below is also in uncertainty.csv.'
  );
}

export function uncertaintySections(parent: Group) {
  for (const run of runs.filter(({ uncertainty }) => uncertainty.figures.length > 0)) {
    element(parent, 'p', ensemblesText(run));
    uncertaintyTable(parent, run);
    uncertaintyFigure(parent, run);
  }
  const text =
    'The range between ensembles contains both parts: that of the parameters, which more knowledge of the site would lessen, ' +
    'and that of the rocks, which is the chance in an ensemble of so many rocks. Variances add up (law of total variance); ' +
    'ranges do not. A dash: the ensembles differ by no more than chance.';
  element(parent, 'p', text, { class: 'quiet' });
}
