// Rocks with shapes: their form after Zingg (1935), how far blocks of each form go, and whether they roll as wheels.

import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, type Group, type LegendEntry } from '../figures/plot';
import { tip } from '../figures/tip';
import type { EndPoint } from './data';
import { element, figure } from './figure';
import { axisIn, count, displayOf, isNumber, number, unitIn } from './format';
import { endText, runs, single, type Run } from './run';
import { table, type Row } from './tables';

const forms = {
  equant: { text: 'equant', colour: '#0072b2' },
  flat: { text: 'flat', colour: '#d55e00' },
  long: { text: 'long', colour: '#009e73' },
  blade: { text: 'flat and long', colour: '#b5589a' },
  sphere: { text: 'sphere', colour: '#777777' },
};
type Form = keyof typeof forms;
const formOrder: readonly Form[] = ['equant', 'flat', 'long', 'blade', 'sphere'];
const formLimit = 2 / 3; // of b/a and c/b

/// The ratios b/a and c/b of a block; null: a sphere, or a section, of which no third axis is known.
interface Ratios {
  elongation: number;
  flatness: number;
}
const ratiosOf = ({ a, b, c }: EndPoint): Ratios | null =>
  isNumber(a) && isNumber(b) && isNumber(c) ? { elongation: b / a, flatness: c / b } : null;

function formOf(end: EndPoint): Form {
  const ratios = ratiosOf(end);
  if (!ratios) return 'sphere';
  const [isLong, isFlat] = [ratios.elongation < formLimit, ratios.flatness < formLimit];
  if (isLong) return isFlat ? 'blade' : 'long';
  return isFlat ? 'flat' : 'equant';
}

export const hasForms = (run: Run) => run.endpoints.some(({ c }) => isNumber(c));
// One run with blocks: its end points have the colours of their forms.
const showsForms = single && runs.every(hasForms);
const formsIn = (ends: readonly EndPoint[]) => formOrder.filter((form) => ends.some((end) => formOf(end) === form));
const formColour = (end: EndPoint) => forms[formOf(end)].colour;

export const endColour = (run: Run, end: EndPoint) => (showsForms ? formColour(end) : run.colour);
export function endSigns({ endpoints, colour }: Run): LegendEntry[] {
  if (!showsForms) return [{ text: 'end point', draw: sign.circle('end', colour) }];
  return formsIn(endpoints).map((form) => ({ text: `end point, ${forms[form].text}`, draw: sign.circle('end', forms[form].colour) }));
}

interface RatioFigure {
  title: string;
  ratio: keyof Ratios;
  name: string;
  column: string;
  ends: string;
}
const ratioFigures: readonly RatioFigure[] = [
  { title: 'Runout by elongation', ratio: 'elongation', name: 'b/a', column: 'b_over_a', ends: 'long … equant' },
  { title: 'Runout by flatness', ratio: 'flatness', name: 'c/b', column: 'c_over_b', ends: 'flat … equant' },
];

function ratioFigure(parent: Group, run: Run, { title, ratio, name, column, ends }: RatioFigure) {
  const dots = run.endpoints.flatMap((end) => {
    const ratios = ratiosOf(end);
    return ratios ? [{ end, value: ratios[ratio] }] : [];
  });
  figure(parent, {
    title,
    label: `${title}: runout of each block against ${name}`,
    caption: `One dot for each of ${count(dots.length, 'block')}; ${name} from ${ends}.`,
    draw(svg, width) {
      const side = { left: 62, right: width - 12, top: 12, bottom: 214 };
      const runouts = dots.map(({ end }) => end.runout_xy);
      const toX = d3.scaleLinear().domain(extentOf(dots.map(({ value }) => value))).range([side.left, side.right]);
      const toY = d3.scaleLinear().domain(extentOf([0, ...runouts])).range([side.bottom, side.top]);
      axes(svg, toX, axisIn('m', toY), side, { xLabel: name, yLabel: `Runout on plan [${unitIn('m')}]`, xTicks: 6 });
      const circles = svg.append('g').selectAll('circle').data(dots).enter().append('circle').attr('class', 'dot').attr('r', 3);
      circles.style('--run', ({ end }) => formColour(end));
      circles.attr('cx', ({ value }) => toX(value)).attr('cy', ({ end }) => toY(end.runout_xy));
      const textOf = endText(run);
      tip(circles, ({ end }) => textOf(end));
      const signs = formsIn(dots.map(({ end }) => end)).map((form) => ({
        text: forms[form].text,
        draw: sign.circle('dot', forms[form].colour),
      }));
      return legend(svg, signs, side.left, side.bottom + 52, side.right) + 12;
    },
    rows: () => [['rock', column, 'runout_m'], ...dots.map(({ end, value }) => [end.rock, value, end.runout_xy])],
  });
}

const meanText = (values: readonly number[], times = 1) => {
  const mean = d3.mean(values);
  return number(mean === undefined ? null : times * mean, 3);
};
const shownIn = (unit: string, value: number | undefined) => number(value === undefined ? null : value / displayOf(unit).per, 4);

function formRow(form: Form, all: readonly EndPoint[]): Row {
  const ends = all.filter((end) => formOf(end) === form);
  const ratios = ends.flatMap((end) => ratiosOf(end) ?? []);
  const runouts = ends.map(({ runout_xy }) => runout_xy);
  const highest = (of: (end: EndPoint) => number) => d3.quantile(ends, 0.95, of);
  return [
    forms[form].text,
    number(ends.length),
    meanText(ratios.map(({ elongation }) => elongation)),
    meanText(ratios.map(({ flatness }) => flatness)),
    shownIn('m', d3.mean(runouts)),
    shownIn('m', d3.quantile(runouts, 0.95)),
    shownIn('J', highest(({ max_ke }) => max_ke)),
    shownIn('m', highest(({ max_bounce }) => max_bounce)),
    form === 'sphere' ? '–' : meanText(ends.map(({ share }) => share).filter(isNumber), 100),
  ];
}

function formTable(parent: Group, { endpoints, endpointTotal }: Run) {
  const [m, J] = [unitIn('m'), unitIn('J')];
  table(parent, {
    caption: endpointTotal > endpoints.length ? `Blocks by their form, of ${number(endpoints.length)} rocks` : 'Blocks by their form',
    head: [
      [
        ...['Form', 'Rocks', 'b/a', 'c/b'],
        { text: 'Runout, mean', unit: m },
        { text: 'Runout, 95 %', unit: m },
        { text: 'Maximum energy, 95 %', unit: J },
        { text: 'Maximum bounce, 95 %', unit: m },
        { text: 'Share of spin', unit: '%' },
      ],
    ],
    numeric: (column) => column > 0,
    rows: formsIn(endpoints).map((form) => formRow(form, endpoints)),
  });
}

const explanation =
  'a, b and c are the lengths of a block along its principal axes, the longest first. Forms after Zingg (1935): ' +
  'flat if c/b, long if b/a is below 2/3. The share of spin is the part of its angular momentum along the ' +
  'shortest axis, over the time of its flights: near 100 % a block rolls on edge, as a wheel; 50 % is no ' +
  'preference.';

export function shapeSections(parent: Group) {
  for (const run of runs.filter(hasForms)) {
    if (!single) element(parent, 'h3', run.label);
    const box = element(parent, 'div', null, { class: 'columns' });
    for (const each of ratioFigures) ratioFigure(box, run, each);
    formTable(parent, run);
  }
  element(parent, 'p', explanation, { class: 'quiet' });
}
