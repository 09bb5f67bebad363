// Rocks, energies, velocities and heights along a line, stretch by stretch, with the worst stretch marked.

import type { Cell } from './files';
import { fromZero, openDrawing, openPlot, rangeText, readAlong, sign, titleOf, valueText, type Quantity, type Room } from './plot';

export interface Stretch {
  /// Along the line [m].
  from: number;
  to: number;
  rocks: number;
  /// With the ends of its confidence interval; null: unknown, or no rock.
  value: number | null;
  low: number | null;
  high: number | null;
}

export interface LineProfile extends Quantity {
  stretches: readonly Stretch[];
  /// Index of the worst stretch; null: no rock crosses.
  worst: number | null;
  colour: string;
  hover: (k: number | null) => void;
}

export function lineProfile(element: SVGSVGElement, room: Room, { title, unit, per, stretches, worst, colour, hover }: LineProfile) {
  const svg = openDrawing(element, room);
  const shown = (value: number | null) => (value === null ? null : value / per);
  const rows = stretches.map(({ value, low, high, ...place }) => ({ ...place, value: shown(value), low: shown(low), high: shown(high) }));
  const heights = rows.flatMap(({ value, high }) => [value, high]).filter((value) => value !== null);
  const hasIntervals = rows.some(({ low, high }) => low !== null || high !== null);
  const { side, x, y } = openPlot(svg, room, {
    x: [Math.min(0, rows[0]?.from ?? 0), rows.at(-1)?.to ?? 1],
    y: fromZero(heights),
    xLabel: 'Along the line [m]',
    yLabel: titleOf({ title, unit }),
    entries: [
      ...(hasIntervals ? [{ text: 'confidence interval', draw: sign.line('whisker', colour) }] : []),
      ...(worst === null ? [] : [{ text: 'worst stretch', draw: sign.box('worst') }]),
    ],
  });
  rows.forEach(({ from, to, value, low, high }, k) => {
    const [left, width] = [x(from), x(to) - x(from)];
    if (k === worst)
      svg.append('rect').attr('class', 'worst').attr('x', left).attr('width', width).attr('y', side.top).attr('height', side.bottom - side.top);
    if (value !== null)
      svg
        .append('rect')
        .attr('class', 'bar')
        .style('--run', colour)
        .attr('x', left + 0.5)
        .attr('width', Math.max(1, width - 1))
        .attr('y', y(value))
        .attr('height', side.bottom - y(value));
    const middle = left + width / 2;
    // Without an upper end the interval is open: its line goes to the top of the plot.
    if (value !== null && (low !== null || high !== null))
      svg
        .append('line')
        .attr('class', high === null ? 'whisker open' : 'whisker')
        .style('--run', colour)
        .attr('x1', middle)
        .attr('x2', middle)
        .attr('y1', y(low ?? 0))
        .attr('y2', high === null ? side.top : y(high));
  });
  const places = rows.map(({ from, to }) => (from + to) / 2);
  return readAlong(
    svg,
    { side, x, y, second: null },
    places,
    (k) => {
      const { from, to, rocks, value, low, high } = rows[k]!;
      const ends = low === null && high === null ? '' : ` (${low === null ? '–' : valueText(low, '')} to ${high === null ? 'unknown: too few rocks' : valueText(high, '')})`;
      return [
        `${rangeText(from, to, 'm')}${k === worst ? ', the worst stretch' : ''}`,
        `${rocks.toLocaleString('en')} rocks`,
        ...(value === null ? [] : [`${title} ${valueText(value, unit)}${ends}`]),
      ].join('\n');
    },
    hover,
  );
}

/// The numbers of the answer.
export const lineProfileRows = (key: string, stretches: readonly Stretch[]): Cell[][] => [
  ['from_m', 'to_m', 'rocks', key, `${key}_low`, `${key}_high`],
  ...stretches.map(({ from, to, rocks, value, low, high }) => [from, to, rocks, value ?? '', low ?? '', high ?? '']),
];
