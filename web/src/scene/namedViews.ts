// Views of the whole model from a side.

import { Box3, Vector3 } from 'three';
import type { Stage } from './stage';

export const namedViews = {
  oblique: { title: 'Oblique', key: '1' },
  plan: { title: 'Plan', key: '2' },
  north: { title: 'From the north', key: '3' },
  south: { title: 'From the south', key: '4' },
  east: { title: 'From the east', key: '5' },
  west: { title: 'From the west', key: '6' },
  fit: { title: 'Fit', key: '7' },
} as const;
export type NamedView = keyof typeof namedViews;

// From where the model is looked at.
const sides: Record<Exclude<NamedView, 'fit'>, [number, number, number]> = {
  oblique: [0.62, -0.85, 0.62],
  plan: [0, -1e-4, 1],
  north: [0, 1, 0.12],
  south: [0, -1, 0.12],
  east: [1, 0, 0.12],
  west: [-1, 0, 0.12],
};

/// Moves the camera so that the whole box is in the picture.
export function look(stage: Stage, name: NamedView, box: Box3) {
  const { camera, controls } = stage;
  const stretched = box.clone();
  stretched.min.z *= stage.world.scale.z;
  stretched.max.z *= stage.world.scale.z;
  const centre = stretched.getCenter(new Vector3());
  const from =
    name === 'fit' ? camera.position.clone().sub(controls.target).normalize() : new Vector3(...sides[name]).normalize();
  const right = new Vector3(0, 0, 1).cross(from).normalize();
  if (right.lengthSq() < 0.5) right.set(1, 0, 0);
  const up = from.clone().cross(right);
  const tanY = Math.tan((camera.fov * Math.PI) / 360) * 0.9;
  const tanX = tanY * camera.aspect;
  let distance = 0.1;
  for (let k = 0; k < 8; ++k) {
    const corner = new Vector3(
      k & 1 ? stretched.max.x : stretched.min.x,
      k & 2 ? stretched.max.y : stretched.min.y,
      k & 4 ? stretched.max.z : stretched.min.z,
    ).sub(centre);
    const toward = corner.dot(from);
    distance = Math.max(distance, toward + Math.abs(corner.dot(right)) / tanX, toward + Math.abs(corner.dot(up)) / tanY);
  }
  controls.target.copy(centre);
  camera.position.copy(centre).addScaledVector(from, distance);
  controls.update();
  stage.invalidate();
}
