// Tornado plot: effects of inputs on a result as horizontal bars, the largest on top.

import { measured } from '../units/numbers';
import { extentOf, openDrawing, openPlot, titleOf, type Quantity, type Room } from './plot';
import { tip } from './tip';

export interface TornadoBar {
  name: string;
  /// Drawn in grey: what the others are compared with.
  quiet?: boolean;
  /// The length of the bar, and the ends of its interval.
  value: number;
  low: number | null;
  high: number | null;
  /// A filled part of the bar, which is then an outline.
  inner?: number | null;
  /// A diamond, which may be negative.
  mark?: number | null;
  /// Another bar below it in the same row, for a change in the other direction; `row` then names both.
  other?: TornadoBar;
  row?: string;
}

export interface Tornado extends Quantity {
  bars: readonly TornadoBar[];
  /// Bars can be chosen with the pointer.
  choose?: (bar: TornadoBar) => void;
}

const letterWidth = 6.4;

/// A name shortened to `width` units; its end is kept, which tells settings of one table apart.
export const shortened = (name: string, width: number) => {
  const letters = Math.floor(width / letterWidth);
  return name.length <= letters ? name : `…${name.slice(name.length - Math.max(1, letters - 1))}`;
};

export function tornado(element: SVGSVGElement, room: Room, { title, unit, bars, choose }: Tornado) {
  const svg = openDrawing(element, room);
  const longest = Math.max(1, ...bars.map(({ name, row }) => (row ?? name).length));
  const nameWidth = Math.min(0.52 * room.width, letterWidth * longest);
  const all = bars.flatMap((bar) => (bar.other ? [bar, bar.other] : [bar]));
  const reached = all.flatMap(({ value, low, high, inner, mark }) => [
    0,
    value,
    ...[low, high, inner, mark].filter((each): each is number => typeof each === 'number'),
  ]);
  const { side, x } = openPlot(svg, room, {
    x: extentOf(reached, 0.04),
    y: [0, 1],
    xLabel: titleOf({ title, unit }),
    yLabel: '',
    names: 24 + nameWidth,
  });
  const each = (side.bottom - side.top) / Math.max(bars.length, 1);
  const half = Math.min(9, 0.34 * each);
  svg
    .append('line')
    .attr('class', 'whisker')
    .attr('x1', x(0))
    .attr('x2', x(0))
    .attr('y1', side.top)
    .attr('y2', side.bottom);
  const drawBar = (bar: TornadoBar, middle: number, half: number, colour: string) => {
    const g = svg.append('g').style('--run', bar.quiet ? 'var(--faint, #999)' : colour);
    if (choose) g.style('cursor', 'pointer').on('click', () => choose(bar));
    const box = (value: number, name: string) =>
      g
        .append('rect')
        .attr('class', name)
        .attr('x', Math.min(x(0), x(value)))
        .attr('width', Math.max(Math.abs(x(value) - x(0)), 0.5))
        .attr('y', middle - half)
        .attr('height', 2 * half);
    const hasInner = typeof bar.inner === 'number';
    box(bar.value, hasInner ? 'box' : 'bar');
    if (typeof bar.inner === 'number') box(bar.inner, 'bar');
    const line = (from: number, to: number, up: number) =>
      g
        .append('line')
        .attr('class', 'whisker')
        .attr('x1', x(from))
        .attr('x2', x(to))
        .attr('y1', middle - up)
        .attr('y2', middle + up);
    line(bar.low ?? bar.value, bar.high ?? bar.value, 0);
    for (const end of [bar.low, bar.high]) if (typeof end === 'number') line(end, end, half / 2);
    if (typeof bar.mark === 'number')
      g.append('path')
        .attr('class', 'mean')
        .attr('d', `M${x(bar.mark) - 5},${middle}l5,-5l5,5l-5,5Z`);
    const value = (number: number) => `${measured(number, 3)}${unit && ` ${unit}`}`;
    const rows = [`${bar.name}: ${value(bar.value)}`];
    if (typeof bar.low === 'number' && typeof bar.high === 'number')
      rows.push(`interval ${value(bar.low)} to ${value(bar.high)}`);
    if (typeof bar.inner === 'number') rows.push(`alone ${value(bar.inner)}`);
    if (typeof bar.mark === 'number') rows.push(`mean ${value(bar.mark)}`);
    tip(g, () => rows.join('\n'));
  };
  bars.forEach((bar, k) => {
    const middle = side.top + (k + 0.5) * each;
    svg
      .append('text')
      .attr('x', side.left - 10)
      .attr('y', middle + 4)
      .attr('text-anchor', 'end')
      .text(shortened(bar.row ?? bar.name, nameWidth))
      .append('title')
      .text(bar.row ?? bar.name);
    if (!bar.other) return drawBar(bar, middle, half, 'var(--run-a)');
    drawBar(bar, middle - half / 2, half / 2 - 0.5, 'var(--run-a)');
    drawBar(bar.other, middle + half / 2, half / 2 - 0.5, 'var(--run-b)');
  });
}
