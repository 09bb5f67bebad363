// The part of a section that trajectories take.

import type { DrawnPaths } from './drawnPaths';

/// Its centre x and z, its width and its height, a tenth wider [m]; null without trajectories.
export function boundsOfPaths({ positions, header: { origin } }: Pick<DrawnPaths, 'positions' | 'header'>): [number, number, number, number] | null {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let k = 0; k + 2 < positions.length; k += 3) {
    const [x, z] = [origin[0] + positions[k]!, origin[2] + positions[k + 2]!];
    [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, z), Math.max(high, z)];
  }
  if (right < left) return null;
  return [(left + right) / 2, (low + high) / 2, 1.1 * Math.max(right - left, 1), 1.1 * Math.max(high - low, 1)];
}
