// The blocks at a time: between two poses they move straight and turn evenly.

import type { DrawnBlocks } from './drawnBlocks';

export type Turn = readonly [x: number, y: number, z: number, w: number];

/// The first index from `first` up to `last` with a time at or after `time`; `last` if there is none.
function indexAt(times: ArrayLike<number>, first: number, last: number, time: number): number {
  let [low, high] = [first, last];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/// The quaternion at a share of the shorter turn from `turns` at index `a` to that at index `b`, into `result` at `to`.
export function turnBetween(turns: ArrayLike<number>, a: number, b: number, share: number, result: Float32Array, to: number) {
  const at = (index: number, axis: number) => turns[4 * index + axis]!;
  const dot = at(a, 0) * at(b, 0) + at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2) + at(a, 3) * at(b, 3);
  const half = Math.acos(Math.min(1, Math.abs(dot)));
  // Below this angle its sine is the angle.
  const [ofA, ofB] = half < 1e-3 ? [1 - share, share] : [Math.sin((1 - share) * half) / Math.sin(half), Math.sin(share * half) / Math.sin(half)];
  for (let axis = 0; axis < 4; ++axis) result[to + axis] = ofA * at(a, axis) + (dot < 0 ? -ofB : ofB) * at(b, axis);
}

/// A vector of the block's frame, turned.
export function turned([x, y, z, w]: Turn, px: number, py: number, pz: number): [number, number, number] {
  const [tx, ty, tz] = [2 * (y * pz - z * py), 2 * (z * px - x * pz), 2 * (x * py - y * px)];
  return [px + w * tx + y * tz - z * ty, py + w * ty + z * tx - x * tz, pz + w * tz + x * ty - y * tx];
}

export class BlocksAtTime {
  /// Of the centres, three numbers per block, relative to the origin of the blocks [m].
  readonly positions: Float32Array;
  /// Quaternions x, y, z, w.
  readonly turns: Float32Array;

  constructor(private readonly blocks: DrawnBlocks) {
    this.positions = new Float32Array(3 * blocks.drawn.length);
    this.turns = new Float32Array(4 * blocks.drawn.length);
  }

  /// Reads all poses at a time [s]. A block that has stopped stays in its last pose.
  find(time: number) {
    const { poseStarts, times, positions, turns } = this.blocks;
    for (let k = 0; k < this.blocks.drawn.length; ++k) {
      const [first, last] = [poseStarts[k]!, poseStarts[k + 1]! - 1];
      const b = indexAt(times, first, last, time);
      const a = Math.max(first, b - 1);
      const span = times[b]! - times[a]!;
      const share = span > 0 ? Math.min(1, Math.max(0, (time - times[a]!) / span)) : 1;
      for (let axis = 0; axis < 3; ++axis) {
        const from = positions[3 * a + axis]!;
        this.positions[3 * k + axis] = from + share * (positions[3 * b + axis]! - from);
      }
      turnBetween(turns, a, b, share, this.turns, 4 * k);
    }
  }

  turnOf(block: number): Turn {
    const { turns } = this;
    return [turns[4 * block]!, turns[4 * block + 1]!, turns[4 * block + 2]!, turns[4 * block + 3]!];
  }
}
