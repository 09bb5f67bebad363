// Where the middle one of the drawn rocks ends.

import type { Point3 } from '../api/types';
import type { DrawnPaths } from '../paths/drawnPaths';

/// The end below which half of the rocks end; null without rocks.
export function middleEnd({ starts, positions, header }: Pick<DrawnPaths, 'starts' | 'positions' | 'header'>): Point3 | null {
  const ends = Array.from(starts.subarray(1), (start): Point3 => [0, 1, 2].map((axis) => header.origin[axis]! + positions[3 * (start - 1) + axis]!) as Point3);
  return ends.toSorted((a, b) => a[2] - b[2])[Math.floor(ends.length / 2)] ?? null;
}
