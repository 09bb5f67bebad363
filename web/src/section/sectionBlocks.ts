// The blocks of a section at a time, as outlines.

import { BlocksAtTime, turned } from '../paths/blocksAtTime';
import type { DrawnBlocks } from '../paths/drawnBlocks';

/// Whether a point is within a convex outline.
function isWithin(outline: readonly [number, number][], x: number, z: number): boolean {
  const sides = outline.map(([ax, az], k) => {
    const [bx, bz] = outline[(k + 1) % outline.length]!;
    return (bx - ax) * (z - az) - (bz - az) * (x - ax) > 0;
  });
  return sides.every((side) => side === sides[0]);
}

export class SectionBlocks {
  readonly at: BlocksAtTime;
  private readonly numbers: Map<number, number>; // of the blocks, by the index of the drawn rock

  constructor(private readonly blocks: DrawnBlocks) {
    this.at = new BlocksAtTime(blocks);
    this.numbers = new Map(Array.from(blocks.drawn, (rock, block) => [rock, block]));
  }

  /// The drawn rock whose block is around a point, among those that pass the filter (null: all); -1 if there is none.
  around(x: number, z: number, passes: Uint8Array | null): number {
    for (const rock of [...this.numbers.keys()].reverse()) {
      if ((!passes || passes[rock]) && isWithin(this.outlineOf(rock)!, x, z)) return rock;
    }
    return -1;
  }

  /// The corners of a drawn rock, x and z of the section, in order, at the time that `at` was asked for; null: it has no
  /// shape.
  outlineOf(rock: number): [number, number][] | null {
    const block = this.numbers.get(rock);
    if (block === undefined) return null;
    const { origin, cornerStarts, corners } = this.blocks;
    const turn = this.at.turnOf(block);
    const [x, z] = [origin[0] + this.at.positions[3 * block]!, origin[2] + this.at.positions[3 * block + 2]!];
    return Array.from({ length: cornerStarts[block + 1]! - cornerStarts[block]! }, (_, k) => {
      const from = 3 * (cornerStarts[block]! + k);
      const [dx, , dz] = turned(turn, corners[from]!, corners[from + 1]!, corners[from + 2]!);
      return [x + dx, z + dz];
    });
  }
}
