import { expect, test } from 'vitest';
import { BlocksAtTime, turned, turnBetween } from './blocksAtTime';
import type { DrawnBlocks } from './drawnBlocks';

const half = Math.SQRT1_2;

/// Two blocks: one turns by 90 degrees about z in its first second and stays so, the other rests.
const blocks = {
  drawn: Uint32Array.of(0, 2),
  poseStarts: Uint32Array.of(0, 3, 4),
  times: Float32Array.of(0, 1, 3, 0),
  positions: Float32Array.of(0, 0, 9, 2, 0, 7, 2, 4, 7, 5, 5, 5),
  turns: Float32Array.of(0, 0, 0, 1, 0, 0, half, half, 0, 0, -half, -half, 1, 0, 0, 0),
} as unknown as DrawnBlocks;

function at(time: number) {
  const found = new BlocksAtTime(blocks);
  found.find(time);
  const nose = turned(found.turnOf(0), 1, 0, 0); // where its x axis points
  return { places: [...found.positions], angle: (Math.atan2(nose[1], nose[0]) * 180) / Math.PI, still: [...found.turnOf(1)] };
}

test('a block moves straight and turns evenly', () => {
  const { places, angle, still } = at(0.25);
  expect(places).toEqual([0.5, 0, 8.5, 5, 5, 5]);
  expect(angle).toBeCloseTo(22.5, 4);
  expect(still).toEqual([1, 0, 0, 0]);
});

test('quaternions of opposite signs are the same turn', () => expect(at(2).angle).toBeCloseTo(90, 4));

test('before its release and after its end a block rests', () => {
  expect(at(-1).angle).toBeCloseTo(0, 4);
  expect(at(99).places).toEqual([2, 4, 7, 5, 5, 5]);
  expect(at(Infinity).angle).toBeCloseTo(90, 4);
});

test('it turns the shorter way', () => {
  // From 10 degrees about x to 350.
  const turn = (degrees: number) => [Math.sin((degrees * Math.PI) / 360), 0, 0, Math.cos((degrees * Math.PI) / 360)];
  const result = new Float32Array(4);
  turnBetween([...turn(10), ...turn(350)], 0, 1, 0.5, result, 0);
  expect(Math.abs(result[3]!)).toBeCloseTo(1, 6);
});
