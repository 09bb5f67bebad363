// Which path is meant by a place of the picture.

import { Matrix4, type Vector3 } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import type { Stage } from './stage';

/// The rock whose path passes nearest to a pixel, among those that pass the filter; null: none within `within` pixels.
/// `shift` is where the paths' origin is in the scene.
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
  const shown = new Matrix4()
    .multiplyMatrices(stage.camera.projectionMatrix, stage.camera.matrixWorldInverse)
    .multiply(stage.world.matrixWorld);
  const m = shown.elements;
  let best = { rock: -1, distance: within };
  for (let rock = 0; rock < paths.rocks.length; ++rock) {
    if (passes && !passes[rock]) continue;
    let before: [number, number] | null = null;
    for (let k = paths.starts[rock]!; k < paths.starts[rock + 1]!; ++k) {
      const x = paths.positions[3 * k]! + shift.x;
      const y = paths.positions[3 * k + 1]! + shift.y;
      const z = paths.positions[3 * k + 2]! + shift.z;
      const w = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
      if (w <= 0) {
        before = null; // behind the eye
        continue;
      }
      const across = ((m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / w + 1) * 0.5 * width;
      const down = (1 - (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / w) * 0.5 * height;
      if (before) {
        const [dx, dy] = [across - before[0], down - before[1]];
        const share = Math.max(0, Math.min(1, ((left - before[0]) * dx + (top - before[1]) * dy) / (dx * dx + dy * dy || 1)));
        const distance = Math.hypot(left - before[0] - share * dx, top - before[1] - share * dy);
        if (distance < best.distance) best = { rock, distance };
      }
      before = [across, down];
    }
  }
  return best.rock < 0 ? null : paths.rocks[best.rock]!;
}
