// Where the middle ones of the drawn rocks end.

import type { Point3 } from '../api/types';
import type { DrawnPaths } from '../paths/drawnPaths';

type Paths = Pick<DrawnPaths, 'starts' | 'positions' | 'header'>;

const endsOf = ({ starts, positions, header }: Paths): Point3[] =>
  Array.from(starts.subarray(1), (start): Point3 => [0, 1, 2].map((axis) => header.origin[axis]! + positions[3 * (start - 1) + axis]!) as Point3).toSorted(
    (a, b) => a[2] - b[2],
  );

/// The end below which half of the rocks end; null without rocks.
export function middleEnd(paths: Paths): Point3 | null {
  const ends = endsOf(paths);
  return ends[Math.floor(ends.length / 2)] ?? null;
}

const [fromShare, toShare, most] = [0.4, 0.6, 9];

/// Ends about the middle one, spread over those below which 40 to 60 % of the rocks end, the middle one among them.
export function middleEnds(paths: Paths): Point3[] {
  const ends = endsOf(paths);
  const places = Array.from({ length: most }, (_, k) => Math.floor((fromShare + ((toShare - fromShare) * k) / (most - 1)) * ends.length));
  return [...new Set([Math.floor(ends.length / 2), ...places])].flatMap((place) => ends.slice(place, place + 1));
}

/// The greater side of the rectangle on plan in which these places lie [m].
export const spreadOf = (places: readonly Point3[]): number =>
  places.length === 0 ? 0 : Math.max(...[0, 1].map((axis) => Math.max(...places.map((at) => at[axis]!)) - Math.min(...places.map((at) => at[axis]!))));
