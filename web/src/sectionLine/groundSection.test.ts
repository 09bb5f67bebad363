import { expect, test } from 'vitest';
import { nearest } from '../figures/plot';
import { equalRanges, gapsOf, piecesOf } from './groundSection';

// Begins outside the terrain, has a hole in the middle with a step at its end, and ends outside the terrain.
const section = {
  distance_m: [0, 2, 5, 5, 8, 8, 9],
  z_m: [null, 10, 12, null, 7, 6, null],
  x_m: [0, 2, 5, 5, 8, 8, 9],
  y_m: [1, 1, 1, 1, 1, 1, 1],
};

test('pieces end at holes and at the edge of the terrain', () => {
  expect(piecesOf(section)).toEqual([
    [
      [2, 1, 10],
      [5, 1, 12],
    ],
    [
      [8, 1, 7],
      [8, 1, 6],
    ],
  ]);
});
test('gaps are the parts without terrain', () => {
  expect(gapsOf(section)).toEqual([
    [0, 2],
    [5, 8],
    [9, null],
  ]);
  expect(gapsOf({ distance_m: [0, 4], z_m: [1, 2], x_m: [0, 4], y_m: [0, 0] })).toEqual([]);
});
test('several points without terrain are one gap', () => {
  const evenly = { distance_m: [0, 1, 2, 3], z_m: [5, null, null, 5], x_m: [0, 1, 2, 3], y_m: [0, 0, 0, 0] };
  expect(gapsOf(evenly)).toEqual([[1, 3]]);
});
test('the nearest point, also beyond the ends and between equal distances', () => {
  const distances = [0, 2, 5, 5, 8];
  expect([-1, 0.9, 1.1, 3.6, 99].map((value) => nearest(distances, value))).toEqual([0, 0, 1, 2, 4]);
  expect(nearest([7], 3)).toBe(0);
});
test('equal ranges have the same scale on both axes and include all values', () => {
  for (const [length, height] of [
    [1000, 30],
    [40, 500],
    [10, 0],
  ] as const) {
    const [[left, right], [low, high]] = equalRanges([0, length], [200, 200 + height], 900, 200);
    expect((right - left) / 900).toBeCloseTo((high - low) / 200, 9);
    expect(left).toBe(0);
    expect(right).toBeGreaterThanOrEqual(length);
    expect(low).toBeLessThanOrEqual(200);
    expect(high).toBeGreaterThanOrEqual(200 + height);
  }
});
