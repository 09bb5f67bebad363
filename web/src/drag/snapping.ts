// Snapping of a dragged vertex to other vertices and lines of the model.

import type { Point3 } from '../api/types';
import type { Pixel } from '../geometry/nearness';

/// A vertex with its place in the picture, or a line between two of them.
export interface Mark {
  point: Point3;
  pixel: Pixel;
}
export interface Target {
  /// What it belongs to, in words: "Fence".
  name: string;
  /// One: a vertex. Two: a line.
  marks: readonly [Mark] | readonly [Mark, Mark];
}

export interface Snapped {
  point: Point3;
  /// "a vertex of Fence", "the line of Fence".
  to: string;
}

const [nearVertex, nearLine] = [10, 7]; // pixels

const distance = ([ax, ay]: Pixel, [bx, by]: Pixel) => Math.hypot(ax - bx, ay - by);

/// The nearest vertex, or else the nearest place on a line; null if none is near enough.
export function snap(at: Pixel, targets: readonly Target[]): Snapped | null {
  let best: { away: number; snapped: Snapped } | null = null;
  for (const { name, marks } of targets) {
    if (marks.length !== 1) continue;
    const away = distance(at, marks[0].pixel);
    if (away <= nearVertex && away < (best?.away ?? Infinity)) best = { away, snapped: { point: marks[0].point, to: `a vertex of ${name}` } };
  }
  if (best) return best.snapped;
  for (const { name, marks } of targets) {
    if (marks.length !== 2) continue;
    const [{ point: a, pixel: p }, { point: b, pixel: q }] = marks;
    const along: Pixel = [q[0] - p[0], q[1] - p[1]];
    const square = along[0] ** 2 + along[1] ** 2;
    const share = square > 0 ? Math.max(0, Math.min(1, ((at[0] - p[0]) * along[0] + (at[1] - p[1]) * along[1]) / square)) : 0;
    const away = distance(at, [p[0] + share * along[0], p[1] + share * along[1]]);
    if (away > nearLine || away >= (best?.away ?? Infinity)) continue;
    const point = a.map((value, k) => value + share * (b[k]! - value)) as Point3;
    best = { away, snapped: { point, to: `the line of ${name}` } };
  }
  return best?.snapped ?? null;
}

/// The place rounded to a grid.
export const onGrid = (point: Point3, step: number): Point3 => point.map((value) => Number((Math.round(value / step) * step).toFixed(6))) as Point3;
