// Places on plan.

import type { Point3 } from '../api/types';

/// Whether a point lies within a closed line on plan: a ray to the east crosses it an odd number of times.
export function isWithin([x, y]: readonly [number, number], ring: readonly Point3[]): boolean {
  return ring.reduce((inside, [ax, ay], k) => {
    const [bx, by] = ring[(k + 1) % ring.length]!;
    return ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax) ? !inside : inside;
  }, false);
}

/// To a millimetre, or a centimetre where the ground is wide or there is none yet: finer than anyone points.
export function rounded(value: number, extent: number): number {
  const digits = extent > 200 || extent === 0 ? 2 : 3;
  return Number(value.toFixed(digits));
}
