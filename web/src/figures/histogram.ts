// Histograms. Several runs are counted in the same bins and shown side by side as shares of each.

import { max, sum } from 'd3-array';
import { counted, numberText } from '../units/numbers';
import {
  extentOf,
  fromZero,
  openDrawing,
  openPlot,
  rangeText,
  sign,
  titleOf,
  type Quantity,
  type Range,
  type Room,
} from './plot';
import type { Cell } from './files';
import { tip } from './tip';

export interface Bins {
  name: string;
  /// A CSS colour.
  colour: string;
  /// The edges of the bins, one more than `counts`, in the units of the files.
  edges: readonly number[];
  counts: readonly number[];
}

export interface Histogram extends Quantity {
  /// What is counted: "rock" or "hit".
  thing: string;
  of: readonly Bins[];
}

const degenerateWidth = 6; // of a bar whose bin has no width
const minimumWidth = 1;

export function histogram(element: SVGSVGElement, room: Room, { title, unit, per, thing, of }: Histogram) {
  const svg = openDrawing(element, room);
  const isOne = of.length === 1;
  const series = of.map(({ name, colour, edges, counts }) => {
    const all = sum(counts);
    const bar = (n: number, k: number) => ({
      name,
      n,
      low: edges[k]! / per,
      high: edges[k + 1]! / per,
      share: all > 0 ? (100 * n) / all : 0,
    });
    return { name, colour, all, bars: counts.map(bar).filter(({ n }) => n > 0) };
  });
  const bars = series.flatMap((one) => one.bars);
  const heightOf = (bar: (typeof bars)[number]) => (isOne ? bar.n : bar.share);
  const { side, x, y } = openPlot(svg, room, {
    x: extentOf(
      bars.flatMap(({ low, high }) => [low, high]),
      0.03,
    ),
    y: isOne && (max(bars, heightOf) ?? 0) < 3 ? ([0, 3] as Range) : fromZero(bars.map(heightOf)),
    xLabel: titleOf({ title, unit }),
    yLabel: isOne ? `Number of ${thing}s` : `Share of ${thing}s [%]`,
    entries: isOne ? [] : series.map(({ name, colour }) => ({ text: name, draw: sign.box('bar', colour) })),
  });
  series.forEach(({ colour, bars, all }, place) => {
    // The run's part of the bin.
    const box = ({ low, high }: (typeof bars)[number]) => {
      const whole = x(high) - x(low);
      if (whole < minimumWidth)
        return { left: x(low) + (place - of.length / 2) * degenerateWidth, width: degenerateWidth };
      const width = whole / of.length;
      return { left: x(low) + place * width, width: Math.max(width - (width > 4 ? 1 : 0), minimumWidth) };
    };
    const drawn = svg
      .append('g')
      .style('--run', colour)
      .selectAll('rect')
      .data(bars)
      .enter()
      .append('rect')
      .attr('class', 'bar');
    drawn.attr('x', (bar) => box(bar).left).attr('width', (bar) => box(bar).width);
    drawn.attr('y', (bar) => y(heightOf(bar))).attr('height', (bar) => side.bottom - y(heightOf(bar)));
    tip(drawn, ({ name, n, low, high, share }) =>
      [
        ...(isOne ? [] : [name]),
        rangeText(low, high, unit),
        `${numberText(n)} of ${counted(all, thing)} (${numberText(share, 3)} %)`,
      ].join('\n'),
    );
  });
}

/// The numbers of the files; `column` is the name of the quantity there.
export const histogramRows = (of: readonly Bins[], column: string): Cell[][] => [
  ['of', `${column}_from`, `${column}_to`, 'count', 'share_percent'],
  ...of.flatMap(({ name, edges, counts }) =>
    counts.map((n, k) => [name, edges[k]!, edges[k + 1]!, n, (100 * n) / (sum(counts) || 1)]),
  ),
];
