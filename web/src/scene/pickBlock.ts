// Picks a block in the scene.

import { Matrix4 } from 'three';
import type { BlockMesh } from './blockMesh';
import type { Stage } from './stage';

const leastSize = 5; // pixels; smaller ones are picked by their trajectories

/// The index of the drawn rock whose block is under a pixel of the view, the nearest one to the eye; -1 if there is none.
/// A block is taken as the sphere of its volume.
export function blockUnder(stage: Stage, { places, blocks }: BlockMesh, passes: Uint8Array | null, left: number, top: number): number {
  const { width, height } = stage.size;
  const m = new Matrix4()
    .multiplyMatrices(stage.camera.projectionMatrix, stage.camera.matrixWorldInverse)
    .multiply(stage.world.matrixWorld).elements;
  const perMetre = stage.camera.projectionMatrix.elements[5]! * 0.5 * height; // at a distance of 1 m
  let best = { rock: -1, distance: Infinity };
  blocks.drawn.forEach((rock, k) => {
    if (passes && !passes[rock]) return;
    const [x, y, z] = places(k);
    const across = m[0]! * x + m[4]! * y + m[8]! * z + m[12]!;
    const up = m[1]! * x + m[5]! * y + m[9]! * z + m[13]!;
    const distance = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
    if (distance <= 0 || distance >= best.distance) return;
    const radius = (blocks.paths.radii[rock]! * perMetre) / distance;
    const off = Math.hypot((across / distance + 1) * 0.5 * width - left, (1 - up / distance) * 0.5 * height - top);
    if (radius >= leastSize && off <= radius) best = { rock, distance };
  });
  return best.rock;
}
