// The cumulative distribution: the share of rocks or hits with at most a value.

import { numberText } from '../units/numbers';
import type { Cell } from './files';
import {
  extentOf,
  openDrawing,
  openPlot,
  readAlong,
  sign,
  titleOf,
  valueText,
  type Group,
  type Quantity,
  type Range,
  type Room,
} from './plot';

export interface Steps {
  name: string;
  colour: string;
  /// Values in the units of the files, ascending, and the share up to each; the last share is 1.
  points: readonly (readonly [number, number])[];
}

export interface Cumulative extends Quantity {
  thing: string;
  of: readonly Steps[];
}

/// The share up to a value.
export function shareAt(points: Steps['points'], value: number): number {
  let share = 0;
  for (const [at, upTo] of points) {
    if (at > value) break;
    share = upTo;
  }
  return share;
}

/// Corners of the steps over the whole axis, in percent, rising from 0 at the smallest value.
export function cumulativeCurve(points: Steps['points'], [low, high]: Range): [number, number][] {
  let now = 0;
  const corners = points.flatMap(([value, share]): [number, number][] => {
    const before = now;
    now = 100 * share;
    return [
      [value, before],
      [value, now],
    ];
  });
  return corners.length === 0 ? [] : [[low, 0], ...corners, [high, now]];
}

export function cumulative(element: SVGSVGElement, room: Room, { title, unit, per, thing, of }: Cumulative) {
  const svg = openDrawing(element, room);
  const curves = of.map((one) => ({
    ...one,
    points: one.points.map(([value, share]) => [value / per, share] as const),
  }));
  const values = curves.flatMap(({ points }) => points.map(([value]) => value));
  const places = [...new Set(values)].sort((a, b) => a - b);
  const groups = curves.map(() => svg.append('g') as Group);
  const range = extentOf(values, 0.03);
  const plot = openPlot(svg, room, {
    x: range,
    y: [0, 100],
    xLabel: titleOf({ title, unit }),
    yLabel: `Share of ${thing}s [%]`,
    entries:
      of.length > 1
        ? curves.map(({ name, colour }, k) => ({ text: name, draw: sign.line('step', colour), switches: groups[k]! }))
        : [],
  });
  curves.forEach(({ colour, points }, k) => {
    const corners = cumulativeCurve(points, range).map(
      ([value, share]) => `${plot.x(value).toFixed(2)},${plot.y(share).toFixed(2)}`,
    );
    if (corners.length > 0)
      groups[k]!.raise()
        .append('path')
        .attr('class', 'curve')
        .style('--run', colour)
        .attr('d', `M${corners.join('L')}`);
  });
  readAlong(svg, plot, places, (k) =>
    [
      `at most ${valueText(places[k]!, unit)}`,
      ...curves.map(
        ({ name, points }) =>
          `${of.length > 1 ? `${name}: ` : ''}${numberText(100 * shareAt(points, places[k]!), 4)} %`,
      ),
    ].join('\n'),
  );
}

export const cumulativeRows = (of: readonly Steps[], column: string): Cell[][] => [
  ['of', column, 'share'],
  ...of.flatMap(({ name, points }) => points.map(([value, share]) => [name, value, share])),
];
