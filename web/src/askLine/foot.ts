// Parts of a draped line.

import type { Point2, Point3 } from '../api/types';

/// The part between two distances on plan from its first point [m].
export function partOf(foot: readonly Point3[], from: number, to: number): Point3[] {
  const part: Point3[] = [];
  let way = 0;
  for (let k = 1; k < foot.length; ++k) {
    const [a, b] = [foot[k - 1]!, foot[k]!];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const at = (distance: number): Point3 => {
      const s = length > 0 ? Math.min(Math.max((distance - way) / length, 0), 1) : 0;
      return [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])];
    };
    if (way + length >= from && way <= to) {
      if (part.length === 0) part.push(at(from));
      part.push(at(to));
    }
    way += length;
  }
  return part;
}

/// Points on plan with the elevation of the nearest point of a draped line; `otherwise` without one.
export function onGround(points: readonly Point2[], foot: readonly Point3[], otherwise: number): Point3[] {
  return points.map(([x, y]) => {
    let [best, z] = [Infinity, otherwise];
    for (const [px, py, pz] of foot) {
      const away = Math.hypot(px - x, py - y);
      if (away < best) [best, z] = [away, pz];
    }
    return [x, y, z];
  });
}
