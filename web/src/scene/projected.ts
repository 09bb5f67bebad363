// Where places of the scene are in the picture.

import { Matrix4 } from 'three';
import type { Stage } from './stage';

export interface Projected {
  left: number; // CSS pixels
  top: number;
  /// Pixels per metre there; negative behind the eye.
  perMetre: number;
  /// From the plane of the eye [m].
  distance: number;
}

/// A function of a place without exaggeration, for the present view.
export function projected(stage: Stage): (x: number, y: number, z: number) => Projected {
  const { width, height } = stage.size;
  stage.world.updateWorldMatrix(false, false); // the exaggeration may have changed since the last frame
  const { projectionMatrix, matrixWorldInverse } = stage.camera;
  const m = new Matrix4().multiplyMatrices(projectionMatrix, matrixWorldInverse).multiply(stage.world.matrixWorld).elements;
  return (x, y, z) => {
    const distance = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
    const across = (m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / distance;
    const up = (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / distance;
    const perMetre = (projectionMatrix.elements[5]! * 0.5 * height) / distance;
    return { left: (across + 1) * 0.5 * width, top: (1 - up) * 0.5 * height, perMetre, distance };
  };
}
