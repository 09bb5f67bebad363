// Named views: of the result of the shown run, or of the whole model.

import { Box3, Vector3 } from 'three';
import { bestBox, heightOf, widthOf, type Box, type Placed } from '../geometry/framing';
import type { Pixel } from '../geometry/nearness';
import { outermost } from './outermost';
import type { Stage } from './stage';

export const namedViews = {
  oblique: { title: 'Oblique', key: '1' },
  plan: { title: 'Plan', key: '2' },
  north: { title: 'From the north', key: '3' },
  south: { title: 'From the south', key: '4' },
  east: { title: 'From the east', key: '5' },
  west: { title: 'From the west', key: '6' },
  fit: { title: 'Fit', key: '7' },
  whole: { title: 'Whole model', key: '8' },
} as const;
export type NamedView = keyof typeof namedViews;

/// Whether a view is from where the camera is.
export const keepsDirection = (name: NamedView): name is 'fit' | 'whole' => name === 'fit' || name === 'whole';

// Directions from the model to the camera.
const sides: Record<Exclude<NamedView, 'fit' | 'whole' | 'oblique'>, [number, number, number]> = {
  plan: [0, -1e-4, 1],
  north: [0, 1, 0.12],
  south: [0, -1, 0.12],
  east: [1, 0, 0.12],
  west: [-1, 0, 0.12],
};
const aside = 0.6; // radians from the line of steepest ascent
const above = 0.62;

/// The direction of the oblique view: up the slope, so that its face is visible. Ground without a dominant slope is seen
/// from the south-east, from high enough to look into a bowl.
function oblique(ground: readonly Vector3[]): Vector3 {
  const mean = ground.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(Math.max(1, ground.length));
  // The least-squares plane through the points: z = x fx + y fy from their mean.
  let [xx, xy, yy, xz, yz, zz] = [0, 0, 0, 0, 0, 0];
  for (const point of ground) {
    const { x, y, z } = point.clone().sub(mean);
    [xx, xy, yy, xz, yz, zz] = [xx + x * x, xy + x * y, yy + y * y, xz + x * z, yz + y * z, zz + z * z];
  }
  const determinant = xx * yy - xy * xy;
  const [fx, fy] = [(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant];
  // A face with gullies has most of its relief in this plane; in a crater or a bowl this view would hide the rocks.
  const explained = (fx * xz + fy * yz) / zz;
  if (!(explained > 0.4)) return new Vector3(0.59, -0.81, 1);
  const direction = Math.atan2(-fy, -fx) - aside;
  return new Vector3(Math.cos(direction), Math.sin(direction), above);
}

const corners = ({ min, max }: Box3) =>
  Array.from({ length: 8 }, (_, k) => new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z));

interface Aim extends Placed {
  distance: number;
  /// The offset of the target from the centre of the model, right and up [m].
  right: number;
  up: number;
  middle: Pixel;
}

/// The camera position from which the points (x to the right, y up, z towards the camera) fill a box of the picture.
/// `tan` is the tangent of half the vertical field of view.
function aimFor(seen: readonly Vector3[], box: Box, height: number, tan: number): Aim {
  const fill = 0.97;
  const [tanX, tanY] = [(fill * tan * widthOf(box)) / height, (fill * tan * heightOf(box)) / height];
  let [right, up, distance] = [0, 0, 0.1];
  const depth = (toward: number) => Math.max(1e-3 * distance, distance - toward);
  for (let turn = 0; turn < 4; ++turn) {
    distance = 0.1;
    for (const { x, y, z: toward } of seen)
      distance = Math.max(distance, toward + Math.max(Math.abs(x - right) / tanX, Math.abs(y - up) / tanY));
    // Nearer points look larger, so the centre of the picture is not that of the ground.
    let [l, r, b, t] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const { x, y, z: toward } of seen) {
      const [across, high] = [(x - right) / depth(toward), (y - up) / depth(toward)];
      [l, r, b, t] = [Math.min(l, across), Math.max(r, across), Math.min(b, high), Math.max(t, high)];
    }
    right += ((l + r) / 2) * distance;
    up += ((b + t) / 2) * distance;
  }
  const middle: Pixel = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
  const pixels = height / (2 * tan);
  function* points(): Iterator<Pixel> {
    for (const { x, y, z: toward } of seen)
      yield [middle[0] + ((x - right) / depth(toward)) * pixels, middle[1] - ((y - up) / depth(toward)) * pixels];
  }
  return { size: 1 / distance, points: { [Symbol.iterator]: points }, distance, right, up, middle };
}

/// Moves the camera so that a subject fills the free part of the picture, outside the boxes `over`. `places` are points
/// spread over it; if there are few, its bounding box is used. `standing` are points of seeders and barriers. The slope of
/// the `ground` gives the direction of the oblique view.
export function look(
  stage: Stage,
  name: NamedView,
  { box, places: spread }: { box: Box3; places: readonly Vector3[] },
  standing: readonly Vector3[],
  ground: readonly Vector3[],
  over: readonly Box[],
) {
  const { camera, controls } = stage;
  const stretch = new Vector3(1, 1, stage.world.scale.z);
  const places = [...(spread.length < 30 ? corners(box) : spread), ...standing].map((point) => point.clone().multiply(stretch));
  const from = (
    keepsDirection(name)
      ? camera.position.clone().sub(controls.target)
      : name === 'oblique'
        ? oblique(ground)
        : new Vector3(...sides[name])
  ).normalize();
  const right = new Vector3(0, 0, 1).cross(from).normalize();
  if (right.lengthSq() < 0.5) right.set(1, 0, 0);
  const up = from.clone().cross(right);
  const centre = box.getCenter(new Vector3()).multiply(stretch);
  const seen = places.map((place) => {
    const of = place.sub(centre);
    return new Vector3(of.dot(right), of.dot(up), of.dot(from));
  });
  const outer = outermost(seen);
  const { width, height } = stage.size;
  const tan = Math.tan((camera.fov * Math.PI) / 360);
  const picture = { left: 0, top: 0, right: width, bottom: height };
  const aimed = (points: readonly Vector3[]) => (part: Box) => aimFor(points, part, height, tan);
  const best = bestBox(picture, over, aimed(seen), (part) => aimed(outer)(part).size);
  if (!best) return;
  stage.aimAt(best.middle);
  controls.target.copy(centre).addScaledVector(right, best.right).addScaledVector(up, best.up);
  camera.position.copy(controls.target).addScaledVector(from, best.distance);
  controls.update();
  stage.invalidate();
}
