// Common parts of all figures: ranges, axes, legend, and reading values along an axis. All text is set as text, never as
// markup, because it contains the user's names.

import { extent, max } from 'd3-array';
import { axisBottom, axisLeft, axisRight } from 'd3-axis';
import { scaleLinear, type ScaleLinear } from 'd3-scale';
import { select, type Selection } from 'd3-selection';
import { measured, tickText } from '../units/numbers';
import { endsAround } from './oneValue';
import { hideTip, showTip } from './tip';

/// A D3 selection of any elements and data.
export type Group = Selection<any, any, any, any>;
export type Scale = ScaleLinear<number, number>;
export type Range = [number, number];

/// The size of a figure with axes and legend, in drawing units.
export interface Room {
  width: number;
  height: number;
}

/// The plot area within a drawing.
export interface Side {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/// A quantity with its displayed unit; values of the files are divided by `per` for display.
export interface Quantity {
  title: string;
  unit: string;
  per: number;
}

export const titleOf = ({ title, unit }: { title: string; unit: string }) => (unit ? `${title} [${unit}]` : title);
export const valueText = (value: number, unit: string) => `${measured(value)}${unit && ` ${unit}`}`;
/// "1.5 to 2.0 m", with enough decimals to distinguish the ends.
export const rangeText = (low: number, high: number, unit: string) =>
  high > low
    ? `${tickText(low, high - low)} to ${tickText(high, high - low)}${unit && ` ${unit}`}`
    : valueText(low, unit);

/// The range of all values, extended on both sides by `margin` times its width.
export function extentOf(values: readonly number[], margin = 0.04): Range {
  const one = endsAround(values);
  if (one) return [one.min, one.max];
  const [low, high] = extent(values);
  if (low === undefined || high === undefined) return [0, 1];
  const more = (high - low) * margin;
  return [low - more, high + more];
}

/// From 0 to a little above the maximum.
export const fromZero = (values: readonly number[]): Range => [0, (max(values) || 1) * 1.06];

const textOfTicks = (scale: Scale, count: number) => {
  const [first = 0, second = first + 1] = scale.ticks(count);
  return (value: number) => tickText(value, Math.abs(second - first));
};
const letterWidth = 6.6; // of a digit on the axes
const widest = (scale: Scale, count: number) =>
  letterWidth * (max(scale.ticks(count), (v) => textOfTicks(scale, count)(v).length) ?? 0);

interface Labels {
  xLabel: string;
  yLabel: string;
  xTicks?: number | undefined;
  yTicks?: number | undefined;
}

const ticksOver = (length: number) => Math.max(3, Math.round(length / 45));

/// Draws grid, axes and labels into the plot area; without `y`, only the horizontal axis.
export function axes(svg: Group, x: Scale, y: Scale | null, side: Side, { xLabel, yLabel, xTicks, yTicks }: Labels) {
  const { left, right, top, bottom } = side;
  const nx = xTicks || Math.max(2, Math.floor((right - left) / Math.max(80, widest(x, 8) + 30)));
  const ny = yTicks || ticksOver(bottom - top);
  const blank = () => '';
  const grid = svg.append('g').attr('class', 'grid');
  const across = axisBottom(x)
    .ticks(nx)
    .tickSize(top - bottom)
    .tickFormat(blank);
  grid.append('g').attr('transform', `translate(0,${bottom})`).call(across);
  const below = svg.append('g').attr('class', 'axis').attr('transform', `translate(0,${bottom})`);
  below.call(
    axisBottom(x)
      .ticks(nx)
      .tickSizeOuter(0)
      .tickFormat((v) => textOfTicks(x, nx)(Number(v))),
  );
  const label = (text: string) =>
    svg.append('text').attr('class', 'axis-label').attr('text-anchor', 'middle').text(text);
  // In a narrow plot it ends at the right.
  label(xLabel)
    .attr('x', Math.min((left + right) / 2, right + 12 - (letterWidth * xLabel.length) / 2))
    .attr('y', bottom + 34);
  if (!y) return;
  grid
    .append('g')
    .attr('transform', `translate(${left},0)`)
    .call(
      axisLeft(y)
        .ticks(ny)
        .tickSize(left - right)
        .tickFormat(blank),
    );
  const beside = svg.append('g').attr('class', 'axis').attr('transform', `translate(${left},0)`);
  beside.call(
    axisLeft(y)
      .ticks(ny)
      .tickSizeOuter(0)
      .tickFormat((v) => textOfTicks(y, ny)(Number(v))),
  );
  const upright = label(yLabel);
  // A long label may extend below the plot area, not above it.
  const half = ((upright.node() as SVGTextElement).getComputedTextLength() || yLabel.length * letterWidth) / 2;
  const middle = Math.max((top + bottom) / 2, half + 3);
  upright.attr('transform', `translate(${left - widest(y, ny) - 22},${middle}) rotate(-90)`);
}

/// A symbol 22 units wide around y = 0 and its text. A click hides or shows `switches`.
export interface LegendEntry {
  text: string;
  draw: (group: Group) => void;
  switches?: Group;
}

/// Draws a row of entries, wrapped at `rightmost`. Returns the y of the last line.
export function legend(
  svg: Group,
  entries: readonly LegendEntry[],
  x: number,
  y: number,
  rightmost = Infinity,
): number {
  let [at, line] = [x, y];
  for (const { text, draw, switches } of entries) {
    const group: Group = svg.append('g');
    draw(group);
    const words = group.append('text').attr('x', 28).attr('y', 4).text(text);
    const length = 28 + ((words.node() as SVGTextElement).getComputedTextLength() || text.length * letterWidth) + 20;
    if (at + length > rightmost && at > x) [at, line] = [x, line + 19];
    group.attr('transform', `translate(${at},${line})`);
    at += length;
    if (switches) {
      group
        .attr('class', 'switch')
        .node()
        .addEventListener('click', () => {
          const isHidden = switches.attr('display') === 'none';
          switches.attr('display', isHidden ? null : 'none');
          group.attr('opacity', isHidden ? null : 0.4);
        });
    }
  }
  return line;
}

export const sign = {
  line:
    (className: string, run = '', dash = '') =>
    (g: Group) =>
      g.append('line').attr('class', className).attr('x2', 22).style('--run', run).style('stroke-dasharray', dash),
  box:
    (className: string, run = '') =>
    (g: Group) =>
      g
        .append('rect')
        .attr('class', className)
        .attr('x', 2)
        .attr('y', -6)
        .attr('width', 18)
        .attr('height', 12)
        .style('--run', run),
  circle:
    (className: string, run = '') =>
    (g: Group) =>
      g.append('circle').attr('class', className).attr('cx', 11).attr('r', 3.6).style('--run', run),
};

/// The plot area with its scales.
export interface Plot {
  side: Side;
  x: Scale;
  y: Scale;
  /// Of the axis on the right, if there is one.
  second: Scale | null;
}

interface PlotOptions extends Omit<Labels, 'xTicks' | 'yTicks'> {
  x: Range;
  y: Range;
  entries?: readonly LegendEntry[];
  /// The width of row names, which replace the vertical axis.
  names?: number;
  /// Ranges for a plot area of this size, instead of `x` and `y`.
  fit?: (width: number, height: number) => [Range, Range];
  /// An axis on the right for another quantity.
  second?: { range: Range; label: string } | undefined;
}

/// Draws the axis on the right.
function secondAxis(svg: Group, scale: Scale, { right, top, bottom }: Side, label: string) {
  const count = ticksOver(bottom - top);
  const beside = svg.append('g').attr('class', 'axis').attr('transform', `translate(${right},0)`);
  beside.call(
    axisRight(scale)
      .ticks(count)
      .tickSizeOuter(0)
      .tickFormat((v) => textOfTicks(scale, count)(Number(v))),
  );
  const upright: Group = svg.append('text').attr('class', 'axis-label').attr('text-anchor', 'middle').text(label);
  const half = ((upright.node() as SVGTextElement).getComputedTextLength() || label.length * letterWidth) / 2;
  const middle = Math.max((top + bottom) / 2, half + 3);
  upright.attr('transform', `translate(${right + widest(scale, count) + 24},${middle}) rotate(-90)`);
}

/// Lays out and draws axes and legend. Returns the plot area and its scales.
export function openPlot(svg: Group, { width, height }: Room, options: PlotOptions): Plot {
  const { xLabel, yLabel, entries = [], names, fit, second } = options;
  const rightmost = width - 14;
  const signs: Group = svg.append('g');
  const lines = entries.length > 0 ? legend(signs, entries, 14, 0, rightmost) : 0;
  const bottom = Math.max(60, height - (entries.length > 0 ? 66 + lines : 42));
  signs.attr('transform', `translate(0,${bottom + 54})`);
  const top = 12;
  const leftOf = (y: Range) => {
    const scale = scaleLinear().domain(y).range([bottom, top]);
    return names ?? Math.max(50, widest(scale, ticksOver(bottom - top)) + 36);
  };
  const left = leftOf(options.y);
  const other = second ? scaleLinear().domain(second.range).range([bottom, top]) : null;
  const right = other ? rightmost - Math.max(30, widest(other, ticksOver(bottom - top)) + 20) : rightmost;
  const [xRange, yRange] = fit?.(right - left, bottom - top) ?? [options.x, options.y];
  const side = { left, right, top, bottom };
  const x = scaleLinear().domain(xRange).range([left, right]);
  const y = scaleLinear().domain(yRange).range([bottom, top]);
  axes(svg, x, names === undefined ? y : null, side, { xLabel, yLabel });
  if (second && other) secondAxis(svg, other, side, second.label);
  return { side, x, y, second: other };
}

/// The index of the value nearest to `value` among ascending ones.
export function nearest(ascending: readonly number[], value: number): number {
  let [low, high] = [0, ascending.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (ascending[middle]! <= value) low = middle;
    else high = middle;
  }
  return high < 0 || value - ascending[low]! <= ascending[high]! - value ? low : high;
}

/// Shows a tooltip and a line at the place nearest to the pointer; `places` are ascending on the horizontal axis. Returns
/// a function that shows place k without the pointer (null: none).
export function readAlong(
  svg: Group,
  { side: { left, right, top, bottom }, x }: Plot,
  places: readonly number[],
  textOf: (k: number) => string,
  hover?: (k: number | null) => void,
): (k: number | null) => void {
  const line = svg.append('line').attr('class', 'pointed').attr('y1', top).attr('y2', bottom).attr('display', 'none');
  const cover = svg.append('rect').attr('class', 'under-pointer').attr('x', left).attr('y', top);
  cover.attr('width', right - left).attr('height', bottom - top);
  const node = cover.node() as SVGRectElement;
  const xIn = (event: MouseEvent) => {
    const box = node.getBoundingClientRect();
    return x.invert(left + ((event.clientX - box.left) / (box.width || 1)) * (right - left));
  };
  const mark = (k: number | null) => {
    if (k === null) return void line.attr('display', 'none');
    line.attr('display', null).attr('x1', x(places[k]!)).attr('x2', x(places[k]!));
  };
  node.addEventListener('mousemove', (event) => {
    if (places.length === 0) return;
    const k = nearest(places, xIn(event));
    mark(k);
    showTip(textOf(k), event.clientX, event.clientY);
    hover?.(k);
  });
  node.addEventListener('mouseleave', () => {
    mark(null);
    hideTip();
    hover?.(null);
  });
  return (k) => {
    mark(k);
    const box = node.getBoundingClientRect();
    if (k === null) hideTip();
    else showTip(textOf(k), box.left + ((x(places[k]!) - left) / (right - left)) * box.width, box.top + box.height / 3);
  };
}

/// The position of the pointer in drawing units.
export function pointIn(svg: SVGSVGElement, event: MouseEvent): [number, number] {
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
  return [x, y];
}

/// Clears the element for a new drawing of this size.
export function openDrawing(element: SVGSVGElement, { width, height }: Room): Group {
  const svg: Group = select(element);
  svg.selectAll('*').remove();
  return svg.attr('viewBox', `0 0 ${width} ${height}`).attr('width', width).attr('height', height);
}
