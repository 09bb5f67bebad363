// How the figures develop with the number of rocks, and how many rocks would make them precise.

import * as d3 from '../figures/d3';
import { axes, extentOf, tip } from '../figures/report';
import { element, figure } from './figure';
import { count, displayOf, isNumber, measured, number } from './format';
import { runs, single } from './run';
import { table } from './tables';

export const figureUnit = (figure) => displayOf(figure.unit || 'share');
export const figureTitle = (figure) => figure.text.charAt(0).toUpperCase() + figure.text.slice(1) + (figure.line ? `: ${figure.line}` : '');

// The larger distance from the value to an end of its interval, relative to the value; null without both ends.
function reachOf([, value, low, high]) {
  return isNumber(low) && isNumber(high) && value > 0 ? Math.max(high - value, value - low) / value : null;
}

function convergenceTable(parent, run) {
  const {figures: all, confidence, tolerance} = run.convergence;
  table(parent, {
    caption: `Figures of all rocks with their ${number(100 * confidence)} % confidence intervals${single ? '' : ` · ${run.label}`}`,
    head: [['Figure', 'Rocks', 'Value', 'Interval', 'Precision', `Rocks for ±${number(100 * tolerance)} %`]],
    rows: all.map((each) => {
      const {unit, per} = figureUnit(each);
      const step = each.steps.at(-1);
      if (!step) return [figureTitle(each), '–', '–', '–', '–', '–'];
      const [rocks, value, low, high] = step;
      const reach = reachOf(step), end = (v) => isNumber(v) ? measured(v / per, 4) : '…';
      const more = isNumber(each.rocks_needed) && each.rocks_needed > rocks;
      return [figureTitle(each), number(rocks), `${measured(value / per, 4)} ${unit}`, `${end(low)} to ${end(high)}`,
        reach === null ? '–' : `±${measured(100 * reach, 2)} %`,
        !isNumber(each.rocks_needed) ? '–' : more ? measured(each.rocks_needed, 2) : 'reached'];
    }),
    numeric: (column) => column > 0,
    rowClass: (i) => all[i].rocks_needed > (all[i].steps.at(-1) || [0])[0] ? 'differs' : '',
  });
}

// Values with their intervals over the number of rocks, which doubles from step to step.
function convergenceFigure(parent, run, each) {
  const {unit, per} = figureUnit(each);
  const steps = each.steps.map(([rocks, value, low, high]) => ({rocks, value: value / per, low: isNumber(low) ? low / per : null, high: isNumber(high) ? high / per : null}));
  const title = single ? figureTitle(each) : `${figureTitle(each)} · ${run.label}`;
  figure(parent, {
    title, label: `${title}, over the number of rocks`, caption: '',
    draw(svg, width) {
      const side = {left: 74, right: width - 14, top: 14, bottom: 160};
      const x = d3.scaleLinear().domain([-0.4, steps.length - 0.6]).range([side.left, side.right]);
      const y = d3.scaleLinear().domain(extentOf(steps.flatMap(({value, low, high}) => [value, low ?? value, high ?? value]))).nice().range([side.bottom, side.top]);
      axes(svg, d3.scaleLinear().domain([1, 2]).range([side.left, side.left]), y, side, {xLabel: 'Number of rocks', yLabel: `[${unit}]`, yTicks: 4, xTicks: 1});
      svg.selectAll('.axis').filter((_, i) => i === 0).selectAll('.tick').remove();
      const below = svg.append('g').attr('class', 'axis').attr('text-anchor', 'middle');
      steps.forEach(({rocks}, k) => {
        if ((steps.length - 1 - k) % 2 === 0) below.append('text').attr('x', x(k)).attr('y', side.bottom + 16).text(number(rocks));
      });
      const g = svg.append('g').style('--run', run.colour);
      g.append('path').attr('class', 'curve').attr('d', d3.line()(steps.map(({value}, k) => [x(k), y(value)])));
      steps.forEach(({rocks, value, low, high}, k) => {
        const mark = g.append('g');
        mark.append('line').attr('class', 'whisker').attr('x1', x(k)).attr('x2', x(k)).attr('y1', y(low ?? value)).attr('y2', y(high ?? value));
        for (const end of [low, high].filter(isNumber)) mark.append('line').attr('class', 'whisker').attr('x1', x(k) - 5).attr('x2', x(k) + 5).attr('y1', y(end)).attr('y2', y(end));
        mark.append('circle').attr('class', 'circle').attr('cx', x(k)).attr('cy', y(value)).attr('r', 3.6);
        tip(mark, () => `${count(rocks, 'rock')}: ${measured(value, 4)} ${unit}\n${isNumber(low) ? measured(low, 4) : '…'} to ${isNumber(high) ? measured(high, 4) : '…'} ${unit}`);
      });
      return side.bottom + 44;
    },
    rows: () => [['rocks', 'value', 'low', 'high'], ...each.steps],
  });
}

export function convergenceSections(parent) {
  for (const run of runs.filter((each) => each.convergence.figures.length)) {
    convergenceTable(parent, run);
    const box = element(parent, 'div', null, {class: 'columns'});
    for (const each of run.convergence.figures.filter(({steps}) => steps.length > 1).slice(0, 12)) convergenceFigure(box, run, each);
  }
  element(parent, 'p', 'Each step is a random choice of the run’s rocks, twice as large as the one before and containing it. Vertical lines: confidence intervals, which assume nothing about the distribution; an end is missing where too few rocks have the quantity. ' +
    'The last column of the table takes the width of an interval to fall with the square root of the number of rocks. Rocks at a line count with their first arrival; of more than ten lines, those with the most hits are listed. Intervals account for the number of rocks, not for wrong inputs.', {class: 'quiet'});
}
