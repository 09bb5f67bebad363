// Pictures that lie over the terrain.

import type { Point2, Point3 } from '../api/types';

/// The number of pictures that are drawn over each other: each needs a texture unit of the terrain's shader.
export const mostDraped = 4;

export interface Covering {
  opacity: number;
  /// Of a picture: its south-west and north-east corner, and its size in pixels.
  found: { kind: 'raster'; area: [Point2, Point2]; columns: number; rows: number } | { kind: 'vector' } | null;
}

/// Whether a picture hides the colours of the ground: it is opaque and as large as the terrain. (It may have holes.)
export const hidesGround = (drawn: readonly Covering[], { min, max }: { min: Point3; max: Point3 }) =>
  drawn
    .filter(({ found }) => found?.kind === 'raster')
    .slice(-mostDraped)
    .some(({ opacity, found }) => {
      if (opacity < 1 || found?.kind !== 'raster') return false;
      const [low, high] = found.area;
      return [found.columns, found.rows].every((pixels, axis) => {
        const pixel = (high[axis]! - low[axis]!) / pixels;
        return low[axis]! <= min[axis]! + pixel && high[axis]! >= max[axis]! - pixel;
      });
    });
