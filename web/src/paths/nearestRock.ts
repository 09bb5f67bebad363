// Picks a rock in a view.

import { distanceToLine, type Pixel } from '../geometry/nearness';
import type { DrawnPaths } from './drawnPaths';

/// The rock with the trajectory nearest to a pixel, among those that pass the filter; null if none is within `within`
/// pixels. `pixelOf` returns the pixel of a point; null if it is outside the view.
export function nearestRock(
  paths: DrawnPaths,
  passes: Uint8Array | null,
  pixelOf: (point: number) => Pixel | null,
  place: Pixel,
  within: number,
): number | null {
  let best = { rock: -1, distance: within };
  for (let rock = 0; rock < paths.rocks.length; ++rock) {
    if (passes && !passes[rock]) continue;
    let before: Pixel | null = null;
    for (let k = paths.starts[rock]!; k < paths.starts[rock + 1]!; ++k) {
      const now = pixelOf(k);
      if (before && now) {
        const distance = distanceToLine(place, before, now);
        if (distance < best.distance) best = { rock, distance };
      }
      before = now;
    }
  }
  return best.rock < 0 ? null : paths.rocks[best.rock]!;
}
