// Rocks with shapes: their form after Zingg (1935), how far blocks of each form go, and whether they roll as wheels.

import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, tip } from '../figures/report';
import { element, figure } from './figure';
import { axisIn, count, displayOf, isNumber, number, unitIn } from './format';
import { endText, runs, single } from './run';
import { table } from './tables';

const forms = {
  equant: {text: 'equant', colour: '#0072b2'},
  flat: {text: 'flat', colour: '#d55e00'},
  long: {text: 'long', colour: '#009e73'},
  blade: {text: 'flat and long', colour: '#b5589a'},
  sphere: {text: 'sphere', colour: '#777777'},
};
const formOrder = Object.keys(forms);
const formLimit = 2 / 3;  // of b/a and c/b

function formOf(end) {
  if (!isNumber(end.a) || !isNumber(end.c)) return 'sphere';
  const isLong = end.b / end.a < formLimit, isFlat = end.c / end.b < formLimit;
  return isLong ? (isFlat ? 'blade' : 'long') : isFlat ? 'flat' : 'equant';
}

// Of a section no third axis is known.
export const hasForms = (run) => run.endpoints.some((end) => isNumber(end.c));
// One run with blocks: its end points have the colours of their forms.
const showsForms = runs.length === 1 && hasForms(runs[0]);
const formsIn = (ends) => formOrder.filter((form) => ends.some((end) => formOf(end) === form));
export const endColour = (run, end) => showsForms ? forms[formOf(end)].colour : run.colour;
export const endSigns = (run) => showsForms
  ? formsIn(run.endpoints).map((form) => ({text: `end point, ${forms[form].text}`, draw: sign.circle('end', forms[form].colour)}))
  : [{text: 'end point', draw: sign.circle('end', run.colour)}];

export function shapeSections(parent) {
  for (const run of runs.filter(hasForms)) {
    if (!single) element(parent, 'h3', run.label);
    const box = element(parent, 'div', null, {class: 'columns'});
    ratioFigure(box, run, {title: 'Runout by elongation', ratio: (end) => end.b / end.a, name: 'b/a', column: 'b_over_a', ends: 'long … equant'});
    ratioFigure(box, run, {title: 'Runout by flatness', ratio: (end) => end.c / end.b, name: 'c/b', column: 'c_over_b', ends: 'flat … equant'});
    formTable(parent, run);
  }
  element(parent, 'p', 'a, b and c are the lengths of a block along its principal axes, the longest first. Forms after Zingg (1935): flat if c/b, long if b/a is below 2/3. The share of spin is the part of its angular momentum along the shortest axis, over the time of its flights: near 100 % a block rolls on edge, as a wheel; 50 % is no preference.', {class: 'quiet'});
}

function ratioFigure(parent, run, {title, ratio, name, column, ends}) {
  const dots = run.endpoints.filter((end) => isNumber(end.c));
  const {per} = displayOf('m');
  figure(parent, {
    title, label: `${title}: runout of each block against ${name}`,
    caption: `One dot for each of ${count(dots.length, 'block')}; ${name} from ${ends}.`,
    draw(svg, width) {
      const side = {left: 62, right: width - 12, top: 12, bottom: 214};
      const toX = d3.scaleLinear().domain(extentOf(dots.map(ratio))).range([side.left, side.right]);
      const toY = d3.scaleLinear().domain(extentOf([0, ...dots.map((end) => end.runout_xy)])).range([side.bottom, side.top]);
      axes(svg, toX, axisIn('m', toY), side, {xLabel: name, yLabel: `Runout on plan [${unitIn('m')}]`, xTicks: 6});
      tip(svg.append('g').selectAll('circle').data(dots).enter().append('circle').attr('class', 'dot').attr('r', 3).style('--run', (end) => forms[formOf(end)].colour)
        .attr('cx', (end) => toX(ratio(end))).attr('cy', (end) => toY(end.runout_xy)), endText(run));
      return legend(svg, formsIn(dots).map((form) => ({text: forms[form].text, draw: sign.circle('dot', forms[form].colour)})), side.left, side.bottom + 52, side.right) + 12;
    },
    rows: () => [['rock', column, 'runout_m'], ...dots.map((end) => [end.rock, ratio(end), end.runout_xy])],
  });
}

function formTable(parent, run) {
  const share = (ends, of) => d3.mean(ends, of);
  table(parent, {
    caption: run.endpointTotal > run.endpoints.length ? `Blocks by their form, of ${number(run.endpoints.length)} rocks` : 'Blocks by their form',
    head: [['Form', 'Rocks', 'b/a', 'c/b', {text: 'Runout, mean', unit: unitIn('m')}, {text: 'Runout, 95 %', unit: unitIn('m')}, {text: 'Maximum energy, 95 %', unit: unitIn('J')}, {text: 'Maximum bounce, 95 %', unit: unitIn('m')}, {text: 'Share of spin', unit: '%'}]],
    numeric: (column) => column > 0,
    rows: formsIn(run.endpoints).map((form) => {
      const ends = run.endpoints.filter((end) => formOf(end) === form), isBlock = form !== 'sphere';
      const most = (of) => d3.quantile(ends, 0.95, of);
      const shown = (value, unit) => number(value / displayOf(unit).per, 4);
      return [forms[form].text, number(ends.length), isBlock ? number(share(ends, (e) => e.b / e.a), 3) : '–', isBlock ? number(share(ends, (e) => e.c / e.b), 3) : '–',
        shown(share(ends, (e) => e.runout_xy), 'm'), shown(most((e) => e.runout_xy), 'm'), shown(most((e) => e.max_ke), 'J'), shown(most((e) => e.max_bounce), 'm'),
        isBlock ? number(100 * share(ends, (e) => e.share), 3) : '–'];
    }),
  });
}
