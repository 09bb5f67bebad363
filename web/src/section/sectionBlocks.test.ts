import { expect, test } from 'vitest';
import type { DrawnBlocks } from '../paths/drawnBlocks';
import { SectionBlocks } from './sectionBlocks';

test('an outline is turned about the centre of its block', () => {
  const half = Math.SQRT1_2;
  const blocks = new SectionBlocks({
    origin: [100, 0, 50],
    drawn: Uint32Array.of(3),
    cornerStarts: Uint32Array.of(0, 3),
    poseStarts: Uint32Array.of(0, 1),
    corners: Float32Array.of(2, 0, 0, 0, 0, 1, -2, 0, 0),
    times: Float32Array.of(0),
    positions: Float32Array.of(1, 0, 2),
    turns: Float32Array.of(0, half, 0, half), // by 90 degrees about y: x points down
  } as unknown as DrawnBlocks);
  blocks.at.find(0);
  expect(blocks.outlineOf(3)!.map((corner) => corner.map(Math.round))).toEqual([
    [101, 50],
    [102, 52],
    [101, 54],
  ]);
  expect(blocks.outlineOf(0)).toBe(null);
  expect(blocks.around(101.2, 52, null)).toBe(3);
  expect(blocks.around(101.2, 52, new Uint8Array(4))).toBe(-1);
  expect(blocks.around(100.8, 52, null)).toBe(-1);
});
