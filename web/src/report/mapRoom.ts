// The size of maps and their round scales on paper.

import { extentOf, type Range, type Scale, type Side } from '../figures/plot';
import { drawing } from './figure';

/// What a map shows, in metres.
export interface View {
  x: Range;
  y: Range;
}

/// Around points [x, y], with margins as shares of their extent.
export const viewOf = (points: readonly (readonly [number, number])[], margin: number): View => ({
  x: extentOf(points.map(([x]) => x), margin),
  y: extentOf(points.map(([, y]) => y), margin),
});

/// The room for a map, in drawing units: `across` and `tallest` are those of its frame, which `fills` it if there is
/// ground to show; its notes stand beside the legend, or below it.
export interface MapRoom {
  width: number;
  left: number;
  across: number;
  tallest: number;
  fills: boolean;
  isBeside: boolean;
}

/// The frame of a map and its scales.
export interface MapFrame {
  side: Side;
  /// Drawing units per metre, and the same as the denominator of a scale on paper.
  scale: number;
  denominator: number;
  shown: View;
  toX: Scale;
  toY: Scale;
}

/// The largest 1, 2 or 5 times a power of ten that is at most `maximum`.
export function roundLength(maximum: number): number {
  const power = 10 ** Math.floor(Math.log10(maximum));
  return power * [5, 2, 1].find((times) => times * power <= maximum)!;
}

/// The smallest usual denominator of map scales, such as 2,500, that is at least `minimum`.
export function roundScale(minimum: number): number {
  const power = 10 ** Math.floor(Math.log10(minimum));
  return power * [1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7.5, 10].find((times) => times * power >= minimum * (1 - 1e-9))!;
}

/// Drawing units per metre at the scale 1:`denominator` on paper.
export const unitsPerMetre = (denominator: number) => 1000 / denominator / drawing.mmOnPaper;

/// A tall map takes half the width, so that two fit side by side.
export const mapWidth = ({ x: [x0, x1], y: [y0, y1] }: View) =>
  (x1 - x0) / (y1 - y0) < 1.25 ? drawing.half : drawing.wide;

export const mapRoom = (width: number, tallest = 430, fills = false): MapRoom => ({
  width,
  left: 74,
  across: width - 74 - 12,
  tallest,
  fills,
  isBeside: width >= drawing.wide,
});

/// The minimum number of metres per drawing unit for the view to fit.
export const metresPerUnit = ({ across, tallest }: MapRoom, { x: [x0, x1], y: [y0, y1] }: View) =>
  Math.max((x1 - x0) / across, (y1 - y0) / tallest);

export const mapScaleIn = (room: MapRoom, view: View) => roundScale(metresPerUnit(room, view) * unitsPerMetre(1));
