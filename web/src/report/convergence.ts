// How the figures develop with the number of rocks, and how many rocks would make them precise.

import { figureTitle, type ConvergenceStep, type FigureConvergence, type NamedFigure } from '../archive/uncertainty';
import * as d3 from '../figures/d3';
import { axes, extentOf, type Group } from '../figures/plot';
import { tip } from '../figures/tip';
import { element, figure } from './figure';
import { count, displayOf, isNumber, measured, number } from './format';
import { runs, single, type Run } from './run';
import { table, type Row } from './tables';

export const figureUnit = ({ unit }: NamedFigure) => displayOf(unit || 'share');

const endText = (end: number | null) => (isNumber(end) ? measured(end, 4) : '…');

// The larger distance from the value to an end of its interval, relative to the value; null without both ends.
function reachOf([, value, low, high]: ConvergenceStep): number | null {
  return isNumber(low) && isNumber(high) && value > 0 ? Math.max(high - value, value - low) / value : null;
}

// The step in the displayed unit.
function shownStep(of: NamedFigure, [rocks, value, low, high]: ConvergenceStep) {
  const { per } = figureUnit(of);
  return { rocks, value: value / per, low: isNumber(low) ? low / per : null, high: isNumber(high) ? high / per : null };
}
type ShownStep = ReturnType<typeof shownStep>;

function neededText(needed: number | null, rocks: number): string {
  if (!isNumber(needed)) return '–';
  return needed > rocks ? measured(needed, 2) : 'reached';
}

function convergenceRow(each: FigureConvergence): Row {
  const step = each.steps.at(-1);
  if (!step) return [figureTitle(each), '–', '–', '–', '–', '–'];
  const { unit } = figureUnit(each);
  const { rocks, value, low, high } = shownStep(each, step);
  const reach = reachOf(step);
  return [
    figureTitle(each),
    number(rocks),
    `${measured(value, 4)} ${unit}`,
    `${endText(low)} to ${endText(high)}`,
    reach === null ? '–' : `±${measured(100 * reach, 2)} %`,
    neededText(each.rocks_needed, rocks),
  ];
}

const needsMore = ({ rocks_needed, steps }: FigureConvergence) => {
  const [rocks] = steps.at(-1) ?? [];
  return rocks !== undefined && isNumber(rocks_needed) && rocks_needed > rocks;
};

function convergenceTable(parent: Group, { convergence, label }: Run) {
  const { figures, confidence, tolerance } = convergence;
  table(parent, {
    caption: `Figures of all rocks with their ${number(100 * confidence)} % confidence intervals${single ? '' : ` · ${label}`}`,
    head: [['Figure', 'Rocks', 'Value', 'Interval', 'Precision', `Rocks for ±${number(100 * tolerance)} %`]],
    rows: figures.map(convergenceRow),
    numeric: (column) => column > 0,
    rowClass: (row) => (needsMore(figures[row]!) ? 'differs' : ''),
  });
}

// Values with their intervals over the number of rocks, which doubles from step to step.
function drawSteps(svg: Group, width: number, steps: readonly ShownStep[], unit: string, colour: string): number {
  const side = { left: 74, right: width - 14, top: 14, bottom: 160 };
  const x = d3
    .scaleLinear()
    .domain([-0.4, steps.length - 0.6])
    .range([side.left, side.right]);
  const y = d3
    .scaleLinear()
    .domain(extentOf(steps.flatMap(({ value, low, high }) => [value, low ?? value, high ?? value])))
    .nice()
    .range([side.bottom, side.top]);
  const noTicks = d3.scaleLinear().domain([1, 2]).range([side.left, side.left]);
  axes(svg, noTicks, y, side, { xLabel: 'Number of rocks', yLabel: `[${unit}]`, yTicks: 4, xTicks: 1 });
  svg
    .selectAll('.axis')
    .filter((_, k) => k === 0)
    .selectAll('.tick')
    .remove();
  const below = svg.append('g').attr('class', 'axis').attr('text-anchor', 'middle');
  steps.forEach(({ rocks }, k) => {
    const isNamed = (steps.length - 1 - k) % 2 === 0;
    if (isNamed) below.append('text').attr('x', x(k)).attr('y', side.bottom + 16).text(number(rocks));
  });
  const g = svg.append('g').style('--run', colour);
  const curve = d3.line()(steps.map(({ value }, k) => [x(k), y(value)]));
  g.append('path').attr('class', 'curve').attr('d', curve);
  steps.forEach(({ rocks, value, low, high }, k) => {
    const mark: Group = g.append('g');
    const whisker = (from: number, to: number, arm: number) =>
      mark
        .append('line')
        .attr('class', 'whisker')
        .attr('x1', x(k) - arm)
        .attr('x2', x(k) + arm)
        .attr('y1', y(from))
        .attr('y2', y(to));
    whisker(low ?? value, high ?? value, 0);
    for (const end of [low, high].filter(isNumber)) whisker(end, end, 5);
    mark.append('circle').attr('class', 'circle').attr('cx', x(k)).attr('cy', y(value)).attr('r', 3.6);
    tip(mark, () => `${count(rocks, 'rock')}: ${measured(value, 4)} ${unit}\n${endText(low)} to ${endText(high)} ${unit}`);
  });
  return side.bottom + 44;
}

function convergenceFigure(parent: Group, run: Run, each: FigureConvergence) {
  const steps = each.steps.map((step) => shownStep(each, step));
  const title = single ? figureTitle(each) : `${figureTitle(each)} · ${run.label}`;
  figure(parent, {
    title,
    label: `${title}, over the number of rocks`,
    caption: '',
    draw: (svg, width) => drawSteps(svg, width, steps, figureUnit(each).unit, run.colour),
    rows: () => [['rocks', 'value', 'low', 'high'], ...each.steps],
  });
}

const mostFigures = 12;

export function convergenceSections(parent: Group) {
  for (const run of runs) {
    const { figures } = run.convergence;
    if (figures.length === 0) continue;
    convergenceTable(parent, run);
    const box = element(parent, 'div', null, { class: 'columns' });
    const drawn = figures.filter(({ steps }) => steps.length > 1).slice(0, mostFigures);
    for (const each of drawn) convergenceFigure(box, run, each);
  }
  const text =
    'Each step is a random choice of the run’s rocks, twice as large as the one before and containing it. Vertical lines: ' +
    'confidence intervals, which assume nothing about the distribution; an end is missing where too few rocks have the ' +
    'quantity. The last column of the table takes the width of an interval to fall with the square root of the number of ' +
    'rocks. Rocks at a line count with their first arrival; of more than ten lines, those with the most hits are listed. ' +
    'Intervals account for the number of rocks, not for wrong inputs.';
  element(parent, 'p', text, { class: 'quiet' });
}
