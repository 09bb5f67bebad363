// Levels of detail of trajectories: the points that a drawing within a tolerance needs, and a fair sample of the rocks if
// not all can be drawn.

import type { DrawnPaths } from './drawnPaths';

type Points = Pick<DrawnPaths, 'starts' | 'times' | 'positions'>;

/// For each point the largest tolerance [m] at which it is still needed; infinite at the ends of a trajectory. Between two
/// needed points a rock moves in proportion to the time, and is within the tolerance of where it is then: so a trajectory
/// that is drawn up to a time ends at its rock. The algorithm is TD-TR of Meratnia & de By, Spatiotemporal compression
/// techniques for moving point objects, EDBT 2004, for all tolerances at once. Points of the same time, before and after an
/// impact, go together, because their velocities differ.
export function neededUpTo({ starts, times, positions }: Points): Float32Array {
  const needed = new Float32Array(times.length);
  const waiting: number[] = []; // triples: first and last moment, and the tolerance of what encloses them
  for (let rock = 0; rock + 1 < starts.length; ++rock) {
    const [first, last] = [starts[rock]!, starts[rock + 1]! - 1];
    if (last < first) continue;
    needed[first] = needed[last] = Infinity;
    waiting.push(first, last, Infinity);
    while (waiting.length > 0) {
      const [limit, to, from] = [waiting.pop()!, waiting.pop()!, waiting.pop()!];
      const all = times[to]! - times[from]!;
      let [far, at] = [-1, -1];
      for (let k = from + 1; k < to; ++k) {
        const share = all > 0 ? (times[k]! - times[from]!) / all : 0;
        let away = 0;
        for (let axis = 0; axis < 3; ++axis) {
          const [a, b] = [positions[3 * from + axis]!, positions[3 * to + axis]!];
          away += (positions[3 * k + axis]! - a - share * (b - a)) ** 2;
        }
        if (away > far) [far, at] = [away, k];
      }
      if (at < 0) continue;
      // Not more than what encloses it, so that the points of a coarse drawing are among those of a finer one.
      const own = Math.min(limit, Math.sqrt(far));
      let [low, high] = [at, at];
      while (low - 1 > from && times[low - 1] === times[at]) --low;
      while (high + 1 < to && times[high + 1] === times[at]) ++high;
      needed[low] = needed[high] = own;
      waiting.push(from, low, own, high, to, own);
    }
  }
  return needed;
}

/// The segments to draw.
export interface Segments {
  /// The indices of their first and last points, in turn.
  ends: Uint32Array;
  /// Of the rocks that pass.
  share: number;
}

const golden = (Math.sqrt(5) - 1) / 2;

/// The rocks in an order of which every beginning is spread evenly over their numbers.
export function fairOrder(rocks: number): Uint32Array {
  const keys = Float64Array.from({ length: rocks }, (_, k) => (k * golden) % 1);
  return Uint32Array.from({ length: rocks }, (_, k) => k).sort((a, b) => keys[a]! - keys[b]!);
}

/// At most `most` segments, but one rock at least. `needed`: of `neededUpTo`. Null: all rocks pass.
export function segmentsOf({ starts, times }: Points, needed: Float32Array, order: Uint32Array, passes: Uint8Array | null, tolerance: number, most: number): Segments {
  let [count, drawn, passing] = [0, 0, 0];
  const counts = new Uint32Array(order.length);
  for (const rock of order) {
    if (passes && passes[rock] === 0) continue;
    ++passing;
    if (drawn > 0 && count >= most) continue;
    let before = -1;
    for (let k = starts[rock]!; k < starts[rock + 1]!; ++k) {
      if (needed[k]! <= tolerance) continue;
      if (before >= 0 && times[k] !== times[before]) ++counts[rock]!;
      before = k;
    }
    if (drawn > 0 && count + counts[rock]! > most) {
      counts[rock] = 0;
      count = most; // the sample ends here, whatever room is left, so that short trajectories are not preferred
      continue;
    }
    ++drawn;
    count += counts[rock]!;
  }
  const size = counts.reduce((sum, each) => sum + each, 0);
  const ends = new Uint32Array(2 * size);
  let at = 0;
  for (const rock of order) {
    if (counts[rock] === 0) continue;
    let before = -1;
    for (let k = starts[rock]!; k < starts[rock + 1]!; ++k) {
      if (needed[k]! <= tolerance) continue;
      if (before >= 0 && times[k] !== times[before]) {
        ends[at++] = before;
        ends[at++] = k;
      }
      before = k;
    }
  }
  return { ends, share: passing > 0 ? drawn / passing : 1 };
}

/// The opacity at which a share of the lines covers as much of the ground behind as all do: where n lines overlap, the
/// ground shines through by (1 - opacity)^n.
export const opacityOfShare = (opacity: number, share: number) => Math.min(0.97, 1 - (1 - opacity) ** (1 / Math.max(share, 1e-3)));
