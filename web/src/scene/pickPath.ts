// Picks a trajectory in the scene.

import { Matrix4, type Vector3 } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import { nearestRock } from '../paths/nearestRock';
import type { Stage } from './stage';

/// See `nearestRock`. `shift` is the origin of the trajectories in the scene.
export function rockNear(
  stage: Stage,
  paths: DrawnPaths,
  passes: Uint8Array | null,
  shift: Vector3,
  left: number,
  top: number,
  within: number,
): number | null {
  const { width, height } = stage.size;
  const m = new Matrix4()
    .multiplyMatrices(stage.camera.projectionMatrix, stage.camera.matrixWorldInverse)
    .multiply(stage.world.matrixWorld).elements;
  const pixelOf = (k: number): [number, number] | null => {
    const x = paths.positions[3 * k]! + shift.x;
    const y = paths.positions[3 * k + 1]! + shift.y;
    const z = paths.positions[3 * k + 2]! + shift.z;
    const w = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
    if (w <= 0) return null; // behind the eye
    const across = (m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / w;
    const up = (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / w;
    return [(across + 1) * 0.5 * width, (1 - up) * 0.5 * height];
  };
  return nearestRock(paths, passes, pixelOf, [left, top], within);
}
