// Of many points in space, those that decide how far away a camera must be to see all of them.

import type { Vector3 } from 'three';

const directions = 128;

/// Unit vectors spread evenly over a sphere (on a spiral, by the golden angle).
function onSphere(count: number): [number, number, number][] {
  return Array.from({ length: count }, (_, k) => {
    const z = 1 - (2 * k + 1) / count;
    const radius = Math.sqrt(1 - z * z);
    const angle = k * Math.PI * (3 - Math.sqrt(5));
    return [radius * Math.cos(angle), radius * Math.sin(angle), z];
  });
}

/// The points that are farthest in one of many directions, each once: at most 128, corners of the points' convex hull.
export function outermost<P extends Pick<Vector3, 'x' | 'y' | 'z'>>(points: readonly P[]): P[] {
  if (points.length <= directions) return [...points];
  const found = new Set<P>();
  for (const [x, y, z] of onSphere(directions)) {
    let farthest = points[0]!;
    let most = -Infinity;
    for (const point of points) {
      const along = x * point.x + y * point.y + z * point.z;
      if (along > most) [most, farthest] = [along, point];
    }
    found.add(farthest);
  }
  return [...found];
}
