// Releases, observed stops and predicted stops of a field experiment on plan; both axes have one scale.

import type { PredictedPlan } from '../archive/validation';
import type { Cell } from './files';
import { extentOf, openDrawing, openPlot, sign, type Range, type Room } from './plot';

const kinds = [
  { key: 'predicted', text: 'predicted stop', colour: 'var(--accent)', radius: 2, opacity: 0.25 },
  { key: 'releases', text: 'release', colour: 'var(--ink)', radius: 2, opacity: 1 },
  { key: 'observed', text: 'observed stop', colour: 'var(--observed)', radius: 3, opacity: 1 },
] as const;

const placesOf = (plan: PredictedPlan) => kinds.flatMap(({ key }) => plan[key]);
const rangesOf = (plan: PredictedPlan): [Range, Range] => [
  extentOf(placesOf(plan).map(([x]) => x)),
  extentOf(placesOf(plan).map(([, y]) => y)),
];

/// How tall a figure of this width is.
export function stopsTall(plan: PredictedPlan, width: number): number {
  const [x, y] = rangesOf(plan);
  return Math.min(700, Math.max(220, 80 + (width - 90) * ((y[1] - y[0]) / (x[1] - x[0]))));
}

// Both ranges widened about their centres to one scale.
function toOneScale([x, y]: [Range, Range], width: number, height: number): [Range, Range] {
  const metres = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height);
  const about = ([low, high]: Range, length: number): Range => [(low + high - length) / 2, (low + high + length) / 2];
  return [about(x, metres * width), about(y, metres * height)];
}

export function stopsOnPlan(element: SVGSVGElement, room: Room, plan: PredictedPlan) {
  const svg = openDrawing(element, room);
  const [xRange, yRange] = rangesOf(plan);
  const { x, y } = openPlot(svg, room, {
    x: xRange,
    y: yRange,
    fit: (width, height) => toOneScale([xRange, yRange], width, height),
    xLabel: 'x [m]',
    yLabel: 'y [m]',
    entries: kinds.map(({ text, colour }) => ({ text, draw: sign.circle('bar', colour) })),
  });
  for (const { key, colour, radius, opacity } of kinds) {
    const group = svg.append('g').style('fill', colour).style('fill-opacity', opacity);
    for (const [east, north] of plan[key]) group.append('circle').attr('cx', x(east)).attr('cy', y(north)).attr('r', radius);
  }
}

export const stopRows = (plan: PredictedPlan): Cell[][] => [
  ['of', 'x_m', 'y_m'],
  ...kinds.flatMap(({ key, text }) => plan[key].map(([x, y]): Cell[] => [text, x, y])),
];
