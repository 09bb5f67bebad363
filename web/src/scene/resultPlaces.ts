// Places of a run's trajectories, for views that show its result.

import { Box3, Vector3 } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';

const most = 2000;
const margin = 0.15; // of the extent of the trajectories
const smallest = 20; // m, of what is shown around a few short trajectories

/// At most 2,000 places, spread over all trajectories, moved outwards by a margin. `shift`: of the origin of the paths in
/// the coordinates of the scene.
export function resultPlaces({ positions }: Pick<DrawnPaths, 'positions'>, shift: Vector3): { places: Vector3[]; box: Box3 } {
  const count = positions.length / 3;
  const step = Math.max(1, Math.floor(count / most));
  const places: Vector3[] = [];
  for (let k = 0; k < count; k += step) places.push(new Vector3().fromArray(positions, 3 * k).add(shift));
  const centre = new Box3().setFromPoints(places).getCenter(new Vector3());
  for (const place of places) place.sub(centre).multiplyScalar(1 + margin).add(centre);
  const half = new Vector3(smallest / 2, smallest / 2, 0);
  places.push(centre.clone().sub(half), centre.clone().add(half));
  return { places, box: new Box3().setFromPoints(places) };
}
