// Observed stops over the simulated end points, their distributions, and the distance between both beside that by chance.

import { quantityTitle, type ObservedDistance, type ObservedFacts } from '../archive/observed';
import { cumulative, cumulativeRows } from '../figures/cumulative';
import * as d3 from '../figures/d3';
import { legend, sign, type Group } from '../figures/plot';
import { tip } from '../figures/tip';
import { contoursWithin } from './contours';
import type { ObservedData, Stop } from './data';
import { drawing, element, figure } from './figure';
import { count, displayOf, isNumber, number, resultIn, unitIn } from './format';
import { finishMap, groundOf, layRelief, mapFrame, noteMap, openMap } from './mapframe';
import { mapRoom, mapWidth, viewOf } from './mapRoom';
import { hillshade } from './relief';
import { drawEnds } from './rocks';
import { barriersOf, placeText, runs, single, type Run } from './run';
import { table, type Row } from './tables';
import type { Point } from './travel';

const ofRun = (run: Run) => (single ? '' : ` · ${run.label}`);

// A diamond, so that it differs from a round end point without its colour.
const stopShape = 'M0,-5L5,0L0,5L-5,0Z';
const stopSign = (group: Group) =>
  group.append('path').attr('class', 'stop').attr('d', stopShape).attr('transform', 'translate(11,0)');

const stopText = (run: Run) => (stop: Stop) =>
  [
    `Observed stop${stop.name ? ` ${stop.name}` : ''}`,
    placeText(run, stop),
    ...(isNumber(stop.mass_kg) ? [`mass ${resultIn('kg', stop.mass_kg)} ${unitIn('kg')}`] : []),
  ].join('\n');

function drawStops(group: Group, run: Run, at: (stop: Stop) => Point) {
  const stops = group.append('g').selectAll('path').data(run.stops).enter().append('path');
  stops.attr('class', 'stop').attr('d', stopShape).attr('transform', (stop) => {
    const [x, y] = at(stop);
    return `translate(${x.toFixed(2)},${y.toFixed(2)})`;
  });
  tip(stops, stopText(run));
}

// Returns its width.
function observedPlan(parent: Group, run: Run): number {
  const { endpoints, stops } = run;
  const view = viewOf([...endpoints, ...stops].map(({ x, y }): Point => [x, y]), 0.1);
  const width = mapWidth(view);
  const { relief } = run.terrain;
  const picture = relief && hillshade(relief);
  figure(parent, {
    title: `Observed stops and simulated end points${ofRun(run)}`,
    label: 'Plan with observed stops and simulated end points',
    caption: `${count(stops.length, 'observed stop')}, end points of ${count(endpoints.length, 'simulated rock')}.`,
    width,
    rows: () => [
      ['of', 'x_m', 'y_m'],
      ...endpoints.map(({ x, y }) => ['simulated', x, y]),
      ...stops.map(({ x, y }) => ['observed', x, y]),
    ],
    draw(svg) {
      const room = mapRoom(width);
      const frame = mapFrame(room, view, groundOf([run], view));
      const { side, toX, toY, shown } = frame;
      const inside = openMap(svg, `observed-frame-${run.index}`, frame);
      if (relief && picture) {
        layRelief(inside, frame, relief, picture);
        const line = d3.line<Point>().x(([x]) => toX(x)).y(([, y]) => toY(y));
        for (const { lines } of contoursWithin(relief, shown).lines) {
          inside.append('path').attr('class', 'contour').attr('d', lines.map((each) => line(each)).join(''));
        }
      }
      const at = ({ x, y }: { x: number; y: number }): Point => [toX(x), toY(y)];
      drawEnds(inside, run, at);
      drawStops(inside, run, at);
      finishMap(inside, frame, run, barriersOf(run));
      const y = side.bottom + 58;
      const signs = [
        { text: 'observed stop', draw: stopSign },
        { text: 'simulated end point', draw: sign.circle('end', run.colour) },
      ];
      const lowest = legend(svg, signs, side.left, y, width === drawing.wide ? 0.6 * width : width) + 6;
      return noteMap(svg, room, frame, { run, y, lowest });
    },
  });
  return width;
}

/// A quantity with distributions along a line.
interface OnLine {
  key: string;
  title: string;
  simulated: ObservedFacts;
  observed: ObservedFacts;
}
const onLines = (data: ObservedData): OnLine[] =>
  data.quantities.flatMap((quantity) => {
    const { key, simulated, observed } = quantity;
    return simulated && observed ? [{ key, title: quantityTitle(quantity, data), simulated, observed }] : [];
  });

function observedCurves(parent: Group, run: Run, data: ObservedData) {
  for (const { key, title, simulated, observed } of onLines(data)) {
    const curves = [
      { name: 'simulated', colour: run.colour, points: simulated.cumulative },
      { name: 'observed', colour: 'var(--observed)', points: observed.cumulative },
    ];
    figure(parent, {
      title: title + ofRun(run),
      label: `${title}: cumulative distribution of observed and simulated rocks`,
      caption: '',
      tall: 278,
      fill: (node, room) => cumulative(node, room, { title, ...displayOf('m'), thing: 'rock', of: curves }),
      rows: () => cumulativeRows(curves, `${key}_m`),
    });
  }
}

const chanceText = (share: number) => (share < 0.01 ? '< 1 %' : `${number(100 * share, 2)} %`);

function distanceTable(parent: Group, run: Run, data: ObservedData) {
  const row = (text: string, { value, median, p95, p_value }: ObservedDistance, unit: string): Row => [
    { text, unit: unitIn(unit) },
    ...[value, median, p95].map((each) => resultIn(unit, each)),
    chanceText(p_value),
  ];
  table(parent, {
    caption: `Distance between observed and simulated${ofRun(run)}`,
    head: [['', 'Observed', 'By chance, median', 'By chance, 95 %', 'Chance is as far']],
    rows: data.quantities.flatMap((quantity) => {
      const title = quantityTitle(quantity, data);
      const { energy_distance, kolmogorov_smirnov } = quantity;
      return [
        row(`${title}, energy distance`, energy_distance, 'm'),
        ...(kolmogorov_smirnov ? [row(`${title}, Kolmogorov–Smirnov`, kolmogorov_smirnov, '')] : []),
      ];
    }),
    numeric: (column) => column > 0,
  });
}

function valueTable(parent: Group, run: Run, data: ObservedData) {
  const rows = onLines(data).flatMap(({ title, simulated, observed }) => {
    const row = (of: string, { mean, p05, median, p95 }: ObservedFacts): Row => [
      { text: title, unit: unitIn('m') },
      of,
      ...[mean, p05, median, p95].map((value) => resultIn('m', value)),
    ];
    return [row('observed', observed), row('simulated', simulated)];
  });
  if (rows.length === 0) return;
  table(parent, {
    caption: `Observed and simulated values${ofRun(run)}`,
    head: [['', '', 'Mean', '5 %', 'Median', '95 %']],
    rows,
    numeric: (column) => column > 1,
  });
}

function explanation(run: Run, { rocks, draws }: ObservedData): string {
  const left = run.summary.end_reasons?.['left the model'];
  return [
    `By chance: the same distance of ${count(run.stops.length, 'rock')} drawn from the ${count(rocks, 'simulated rock')} of the page, ${number(draws)} times.`,
    'A distance beyond its 95 % is hardly due to chance alone: places, materials or releases differ from those of ' +
    'the observed rocks. A distance within it does not prove the model; few stops find only large differences.',
    ...(left ? [`${count(left, 'rock')} left the model and count where they left it.`] : []),
    'Energy distance: Székely and Rizzo (2013), twice the mean distance between an observed and a simulated rock, ' +
    'less the mean distances within each.',
  ].join(' ');
}

export function observedFigures(parent: Group) {
  for (const run of runs) {
    const data = run.observed;
    if (!data) continue;
    if (data.rocks === 0) {
      const text = 'There are no end points to compare with: the run wrote none (output.endpoints).';
      element(parent, 'p', text, { class: 'quiet' });
      continue;
    }
    const box = element(parent, 'div', null, { class: 'columns' });
    const planWidth = run.isSection ? null : observedPlan(box, run);
    observedCurves(planWidth === drawing.half ? element(box, 'div') : box, run, data); // beside a tall plan, or below a wide one
    distanceTable(parent, run, data);
    valueTable(parent, run, data);
    element(parent, 'p', explanation(run, data), { class: 'quiet' });
  }
}
