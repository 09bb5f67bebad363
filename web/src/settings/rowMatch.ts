// Matches the rows of a changed list with the former rows, so that parallel lists can follow.

import { isSame } from '../toml/differences';
import type { TomlValue } from '../toml/format';
import { distanceToLine } from '../geometry/nearness';

type Rows = readonly TomlValue[];

/// The number of equal rows at the beginning and at the end, and of the differing rows between them.
function matchOf(before: Rows, after: Rows) {
  const least = Math.min(before.length, after.length);
  let head = 0;
  while (head < least && isSame(before[head], after[head])) ++head;
  let tail = 0;
  while (tail < least - head && isSame(before.at(-1 - tail), after.at(-1 - tail))) ++tail;
  return { head, tail, gone: before.length - head - tail, fresh: after.length - head - tail };
}

/// The former index of each row; null if it is new. Rows that changed in place keep their index.
export function rowsBefore(before: Rows, after: Rows): (number | null)[] {
  const { head, tail, gone, fresh } = matchOf(before, after);
  return after.map((_, k) => {
    if (k < head || gone === fresh) return k;
    return k >= after.length - tail ? k + before.length - after.length : null;
  });
}

type Point = [number, number];
const pointOf = (row: TomlValue | undefined): Point => {
  const [x, z] = Array.isArray(row) ? row.map(Number) : [];
  return [x ?? NaN, z ?? NaN];
};

/// The segment from `first` to `last` that is nearest to the midpoint of another one.
function nearest(before: Rows, first: number, last: number, [a, b]: [Point, Point]): number {
  const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  let best = { segment: first, distance: Infinity };
  for (let k = first; k <= last; ++k) {
    const distance = distanceToLine(middle, pointOf(before[k]), pointOf(before[k + 1]));
    if (distance < best.distance) best = { segment: k, distance };
  }
  return best.segment;
}

/// The former segment of each segment between the rows. After deleted vertices it is the one before them; if vertices are
/// added and deleted at once, it is the nearest one.
export function segmentsBefore(before: Rows, after: Rows): number[] {
  const { head, tail, gone, fresh } = matchOf(before, after);
  const within = (k: number) => Math.max(0, Math.min(k, before.length - 2));
  return Array.from({ length: Math.max(0, after.length - 1) }, (_, k) => {
    if (gone === fresh || k < head - 1) return k;
    if (k >= after.length - tail) return k + before.length - after.length;
    if (gone === 0 || fresh === 0) return within(head - 1);
    const ends: [Point, Point] = [pointOf(after[k]), pointOf(after[k + 1])];
    return nearest(before, within(head - 1), within(before.length - tail - 1), ends);
  });
}
