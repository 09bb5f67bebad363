// Contours of a relief.

import type { Relief } from '../archive/summary';
import * as d3 from '../figures/d3';
import { displayOf, isNumber } from './format';
import type { View } from './mapRoom';
import type { Point } from './travel';

/// A contour at an elevation, as lines of points on plan.
export interface Contour {
  level: number;
  lines: Point[][];
}
export interface Contours {
  /// Between two contours; 0: there are none.
  interval: number;
  lines: Contour[];
}

// They stop at holes and at the edge of the relief.
function contourLines({ columns, rows, cell_m, x0, y0, z_m }: Relief, levels: readonly number[], interval: number): Contour[] {
  const low = (levels[0] ?? 0) - interval * 1000;
  const isKnown = (i: number, j: number) => i >= 0 && j >= 0 && i < columns && j < rows && isNumber(z_m[j * columns + i]);
  const isInside = (a: number, b: number) =>
    [Math.floor(a), Math.ceil(a)].every((i) => [Math.floor(b), Math.ceil(b)].every((j) => isKnown(i, j)));
  const shapes = d3.contours().size([columns, rows]).thresholds([...levels])(z_m.map((z) => z ?? low));
  return shapes.map(({ value, coordinates }) => {
    const lines: Point[][] = [];
    for (const ring of coordinates.flat()) {
      let line: Point[] = [];
      for (const [a = 0, b = 0] of ring) {
        const [i, j] = [a - 0.5, b - 0.5]; // d3-contour has grid points at half-integers
        if (isInside(i, j)) {
          line.push([x0 + i * cell_m, y0 + j * cell_m]);
        } else {
          lines.push(line);
          line = [];
        }
      }
      lines.push(line);
    }
    return { level: value, lines: lines.filter((line) => line.length > 1) };
  });
}

// The relief's heights within a rectangle, or all of them if it contains no grid point.
function heightsWithin({ columns, cell_m, x0, y0, z_m }: Relief, { x: [xLow, xHigh], y: [yLow, yHigh] }: View): number[] {
  const inside = z_m.filter((_, k) => {
    const [x, y] = [x0 + (k % columns) * cell_m, y0 + Math.floor(k / columns) * cell_m];
    return x >= xLow && x <= xHigh && y >= yLow && y <= yHigh;
  });
  const heights = inside.filter(isNumber);
  return heights.length > 0 ? heights : z_m.filter(isNumber);
}

export function contoursWithin(relief: Relief, view: View): Contours {
  const [low = 0, high = 0] = d3.extent(heightsWithin(relief, view));
  const { per } = displayOf('m');
  const levels = high > low ? d3.ticks(low / per, high / per, 25).map((level) => level * per) : [];
  const [first = 0, second = first] = levels;
  const interval = second - first;
  return { interval, lines: interval > 0 ? contourLines(relief, levels, interval) : [] };
}
