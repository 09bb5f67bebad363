// Trajectories beside a line on plan, projected onto its section: what is drawn, not a result.

import type { Point2 } from '../api/types';
import type { DrawnPaths } from '../paths/drawnPaths';

/// The nearest place of a polyline on plan.
export interface Place {
  /// From its first point [m].
  distance: number;
  /// From the line [m].
  aside: number;
  /// Whether it lies before the first or behind the last point.
  isBeyond: boolean;
}

/// Returns the nearest place of the line for a point.
export function placeOnLine(line: readonly Point2[]): (x: number, y: number) => Place {
  let way = 0;
  const pieces = line.slice(1).flatMap(([x, y], k) => {
    const [fromX, fromY] = line[k]!;
    const [dx, dy] = [x - fromX, y - fromY];
    const length = Math.hypot(dx, dy);
    if (length === 0) return [];
    const piece = { fromX, fromY, ux: dx / length, uy: dy / length, length, way };
    way += length;
    return [piece];
  });
  return (x, y) => {
    let best: Place = { distance: 0, aside: Infinity, isBeyond: true };
    pieces.forEach(({ fromX, fromY, ux, uy, length, way }, k) => {
      const along = (x - fromX) * ux + (y - fromY) * uy;
      const at = Math.min(Math.max(along, 0), length);
      const aside = Math.hypot(x - fromX - at * ux, y - fromY - at * uy);
      if (aside >= best.aside) return;
      const isBeyond = (k === 0 && along < 0) || (k === pieces.length - 1 && along > length);
      best = { distance: way + at, aside, isBeyond };
    });
    return best;
  };
}

/// Parts of trajectories within the corridor. Part k has the points from `starts[k]` up to, but excluding, `starts[k + 1]`.
export interface CorridorPaths {
  starts: number[];
  /// For each part the index of its rock among the drawn ones, ascending.
  rocks: number[];
  /// For each point: along the line [m], its elevation [m], and the drawn point that gives its colour.
  distances: number[];
  elevations: number[];
  points: number[];
  /// The number of rocks with a part.
  rockCount: number;
}

const halvings = 20; // of a step, for the place where a trajectory crosses the border of the corridor
const mostSteps = 200; // of a straight piece of a trajectory

/// The parts of the trajectories at most `halfWidth` [m] from the line; `passes`: the rocks of the filter, null: all.
export function pathsInCorridor(
  { header: { origin }, starts, positions, rocks }: Pick<DrawnPaths, 'header' | 'starts' | 'positions' | 'rocks'>,
  line: readonly Point2[],
  halfWidth: number,
  passes: Uint8Array | null,
): CorridorPaths {
  const found: CorridorPaths = { starts: [], rocks: [], distances: [], elevations: [], points: [], rockCount: 0 };
  // Positions are relative to their origin.
  const own = line.map(([x, y]): Point2 => [x - origin[0], y - origin[1]]);
  const place = placeOnLine(own);
  const [xs, ys] = [own.map(([x]) => x), own.map(([, y]) => y)];
  const [left, right] = [Math.min(...xs) - halfWidth, Math.max(...xs) + halfWidth];
  const [low, high] = [Math.min(...ys) - halfWidth, Math.max(...ys) + halfWidth];
  const isInside = (at: Place) => !at.isBeyond && at.aside <= halfWidth;

  for (let rock = 0; rock < rocks.length; ++rock) {
    if (passes && !passes[rock]) continue;
    let isOpen = false;
    let hasPart = false;
    const put = (distance: number, z: number, point: number) => {
      if (!isOpen) {
        found.starts.push(found.distances.length);
        found.rocks.push(rock);
        isOpen = hasPart = true;
      }
      found.distances.push(distance);
      found.elevations.push(z + origin[2]);
      found.points.push(point);
    };
    for (let k = starts[rock]! + 1; k < starts[rock + 1]!; ++k) {
      const at = 3 * k;
      const [ax, ay, az] = [positions[at - 3]!, positions[at - 2]!, positions[at - 1]!];
      const [bx, by, bz] = [positions[at]!, positions[at + 1]!, positions[at + 2]!];
      if ((ax < left && bx < left) || (ax > right && bx > right) || (ay < low && by < low) || (ay > high && by > high)) {
        isOpen = false;
        continue;
      }
      const on = (s: number) => place(ax + s * (bx - ax), ay + s * (by - ay));
      const take = (s: number, there: Place) => put(there.distance, az + s * (bz - az), k);
      const steps = Math.min(mostSteps, Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / Math.max(halfWidth, 0.1))));
      let [before, beforeIsIn] = [0, false];
      for (let step = 0; step <= steps; ++step) {
        const s = step / steps;
        const there = on(s);
        const isIn = isInside(there);
        if (step > 0 && isIn !== beforeIsIn) {
          let [out, inside] = isIn ? [before, s] : [s, before];
          for (let turn = 0; turn < halvings; ++turn) {
            const middle = (out + inside) / 2;
            if (isInside(on(middle))) inside = middle;
            else out = middle;
          }
          take(inside, on(inside));
        }
        if (isIn && (step > 0 || !isOpen)) take(s, there);
        if (!isIn) isOpen = false;
        [before, beforeIsIn] = [s, isIn];
      }
    }
    if (hasPart) ++found.rockCount;
  }
  found.starts.push(found.distances.length);
  return found;
}
