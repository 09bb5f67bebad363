// The scene's coordinates: x east, y north, z up, in metres from a point near the model, so that single precision resolves
// millimetres even if the project's coordinates are millions.

import { Vector3 } from 'three';
import type { Point3 } from '../api/types';

export class Frame {
  constructor(readonly base: Point3) {}

  local([x, y, z]: Point3): Vector3 {
    return new Vector3(x - this.base[0], y - this.base[1], z - this.base[2]);
  }
  project({ x, y, z }: { x: number; y: number; z: number }): Point3 {
    return [x + this.base[0], y + this.base[1], z + this.base[2]];
  }
}
