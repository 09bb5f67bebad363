// Box plots: quartiles with the median, whiskers, minimum and maximum as dots beyond the whiskers, the mean as a cross.

import { max } from 'd3-array';
import { measured } from '../units/numbers';
import type { Cell } from './files';
import { extentOf, openDrawing, openPlot, titleOf, type Group, type Quantity, type Room } from './plot';
import { tip } from './tip';

export interface Box {
  name: string;
  colour: string;
  count: number;
  /// In the units of the files.
  least: number;
  whisker_low: number;
  q1: number;
  median: number;
  q3: number;
  whisker_high: number;
  most: number;
  mean?: number | null;
}

export interface Boxes extends Quantity {
  of: readonly Box[];
}

const figures = ['least', 'whisker_low', 'q1', 'median', 'q3', 'whisker_high', 'most'] as const;
const labels: Record<(typeof figures)[number], string> = {
  least: 'minimum',
  whisker_low: 'lower whisker',
  q1: 'lower quartile',
  median: 'median',
  q3: 'upper quartile',
  whisker_high: 'upper whisker',
  most: 'maximum',
};
const letterWidth = 6.4;

/// A name shortened to `width` units.
const cut = (name: string, width: number) =>
  name.length * letterWidth <= width ? name : `${name.slice(0, Math.max(1, Math.floor(width / letterWidth) - 1))}…`;

export function boxes(element: SVGSVGElement, room: Room, { title, unit, per, of }: Boxes) {
  const svg = openDrawing(element, room);
  const hasNames = of.length > 1;
  const nameWidth = hasNames ? Math.min(0.3 * room.width, letterWidth * (max(of, ({ name }) => name.length) ?? 0)) : 0;
  const values = of.flatMap(({ least, most }) => [least / per, most / per]);
  const { side, x } = openPlot(svg, room, {
    x: extentOf(values, 0.05),
    y: [0, 1],
    xLabel: titleOf({ title, unit }),
    yLabel: '',
    names: 24 + nameWidth,
  });
  const each = (side.bottom - side.top) / Math.max(of.length, 1);
  const half = Math.min(18, 0.36 * each);
  of.forEach((box, k) => {
    const middle = side.top + (k + 0.5) * each;
    const at = (figure: (typeof figures)[number]) => x(box[figure] / per);
    const g: Group = svg.append('g').style('--run', box.colour);
    if (hasNames) {
      const text = g
        .append('text')
        .attr('x', side.left - 10)
        .attr('y', middle + 4)
        .attr('text-anchor', 'end')
        .text(cut(box.name, nameWidth));
      text.append('title').text(box.name);
    }
    const line = (from: number, to: number, up: number, name: string) =>
      g
        .append('line')
        .attr('class', name)
        .attr('x1', from)
        .attr('x2', to)
        .attr('y1', middle - up)
        .attr('y2', middle + up);
    line(at('whisker_low'), at('q1'), 0, 'whisker');
    line(at('q3'), at('whisker_high'), 0, 'whisker');
    for (const end of ['whisker_low', 'whisker_high'] as const) line(at(end), at(end), half / 2, 'whisker');
    const [left, right] = [at('q1'), at('q3')];
    g.append('rect')
      .attr('class', 'box')
      .attr('x', left)
      .attr('width', Math.max(right - left, 0.5))
      .attr('y', middle - half)
      .attr('height', 2 * half);
    line(at('median'), at('median'), half, 'median');
    const ends = (['least', 'most'] as const).filter(
      (end, e) => box[end] !== box[e === 0 ? 'whisker_low' : 'whisker_high'],
    );
    for (const end of ends)
      g.append('circle').attr('class', 'extreme').attr('cx', at(end)).attr('cy', middle).attr('r', 2.5);
    if (typeof box.mean === 'number') {
      const arm = Math.min(5, 0.5 * half);
      g.append('path')
        .attr('class', 'mean')
        .attr(
          'd',
          `M${x(box.mean / per) - arm},${middle - arm}l${2 * arm},${2 * arm}m0,${-2 * arm}l${-2 * arm},${2 * arm}`,
        );
    }
    const shown = [...figures]
      .reverse()
      .filter((figure) =>
        figure === 'whisker_low' ? ends.includes('least') : figure !== 'whisker_high' || ends.includes('most'),
      );
    const rows = shown.map((figure) => `${labels[figure]} ${measured(box[figure] / per)} ${unit}`);
    if (typeof box.mean === 'number') rows.push(`mean ${measured(box.mean / per)} ${unit}`);
    tip(g, () => [...(hasNames ? [`${box.name}: ${measured(box.count)}`] : []), ...rows].join('\n'));
  });
}

export const boxRows = (of: readonly Box[], column: string): Cell[][] => [
  ['of', 'count', ...figures.map((figure) => `${column}_${figure}`)],
  ...of.map((box) => [box.name, box.count, ...figures.map((figure) => box[figure])]),
];
