// Picks a block in the scene.

import type { BlockMesh } from './blockMesh';
import { projected } from './projected';
import type { Stage } from './stage';

const leastSize = 5; // pixels; smaller ones are picked by their trajectories

/// The index of the drawn rock whose block is under a pixel of the view, the nearest one to the eye; -1 if there is none.
/// A block is taken as the sphere of its volume.
export function blockUnder(stage: Stage, { places, blocks }: BlockMesh, passes: Uint8Array | null, left: number, top: number): number {
  const seen = projected(stage);
  let best = { rock: -1, distance: Infinity };
  blocks.drawn.forEach((rock, k) => {
    if (passes && !passes[rock]) return;
    const at = seen(...places(k));
    const radius = blocks.paths.radii[rock]! * at.perMetre;
    if (radius < leastSize || at.distance >= best.distance) return;
    if (Math.hypot(at.left - left, at.top - top) <= radius) best = { rock, distance: at.distance };
  });
  return best.rock;
}
