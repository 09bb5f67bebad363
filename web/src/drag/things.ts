// The seeder, barrier, collector, area or forest under a pixel of a view.

import type { Point3 } from '../api/types';
import { pathOf, type Path } from '../settings/names';
import { model } from '../project/model';
import { distanceToLine, type Pixel } from '../geometry/nearness';
import { layers } from '../view/settings';
import type { DragView } from './drag';

const [nearPoint, nearLine] = [10, 7]; // pixels

export function thingAt(view: DragView, at: Pixel): Path | null {
  const now = model.peek();
  if (!now) return null;
  let [found, least]: [string | null, number] = [null, Infinity];
  const take = (path: string, away: number, reach: number) => {
    if (away < reach && away < least) [found, least] = [path, away];
  };
  const line = (path: string, points: readonly Point3[]) => {
    const pixels = points.map((point) => view.pixelOf(point));
    for (let k = 0; k + 1 < pixels.length; ++k) {
      const [a, b] = [pixels[k], pixels[k + 1]];
      if (a && b) take(path, distanceToLine(at, a, b), nearLine);
    }
  };
  if (layers.barriers.peek())
    for (const { path, foot, top } of now.barriers) {
      line(path, foot);
      line(path, top);
      foot.forEach((point, k) => top[k] && line(path, [point, top[k]!]));
    }
  if (layers.seeders.peek())
    for (const { path, points, lines } of now.seeders) {
      for (const each of lines) line(path, each);
      for (const point of points) {
        const pixel = view.pixelOf(point);
        if (pixel) take(path, Math.hypot(pixel[0] - at[0], pixel[1] - at[1]), nearPoint);
      }
    }
  if (found === null) for (const { path, sides } of [...now.areas, ...now.forests]) for (const side of sides) line(path, side);
  return found === null ? null : pathOf(found);
}
