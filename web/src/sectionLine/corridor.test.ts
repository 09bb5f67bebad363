import { expect, test } from 'vitest';
import type { Point2 } from '../api/types';
import { pathsInCorridor, placeOnLine } from './corridor';

/// Trajectories through points, in millions of metres.
const origin: [number, number, number] = [2_600_000, 1_200_000, 500];
function paths(...lists: [number, number, number][][]) {
  const starts = Uint32Array.from([0, ...lists.map((_, k) => lists.slice(0, k + 1).flat().length)]);
  return {
    header: { origin } as never,
    starts,
    positions: Float32Array.from(lists.flat(2)),
    rocks: Uint32Array.from(lists.map((_, k) => 10 * k)),
  };
}
const at = (x: number, y: number): Point2 => [origin[0] + x, origin[1] + y];

test('the nearest place of a bent line, and places beyond its ends', () => {
  const place = placeOnLine([
    [0, 0],
    [10, 0],
    [10, 10],
  ]);
  expect(place(4, 3)).toEqual({ distance: 4, aside: 3, isBeyond: false });
  expect(place(12, 7)).toEqual({ distance: 17, aside: 2, isBeyond: false });
  expect(place(11, -1)).toMatchObject({ distance: 10, isBeyond: false }); // outside of the bend
  expect(place(-1, 0).isBeyond).toBe(true);
  expect(place(10, 11).isBeyond).toBe(true);
});

test('a trajectory is cut where it crosses the border of the corridor', () => {
  // Crosses the line at right angles at x = 30; 20 m lower at the end.
  const found = pathsInCorridor(paths([[30, 20, 40], [30, -20, 20]]), [at(0, 0), at(100, 0)], 5, null);
  expect(found.rocks).toEqual([0]);
  expect(found.starts[0]).toBe(0);
  for (const distance of found.distances) expect(distance).toBeCloseTo(30, 3);
  expect(found.elevations[0]).toBeCloseTo(500 + 32.5, 3);
  expect(found.elevations.at(-1)).toBeCloseTo(500 + 27.5, 3);
  expect(found.points.every((point) => point === 1)).toBe(true);
});

test('one that leaves and returns has two parts, of one rock', () => {
  const there = pathsInCorridor(paths([[10, 0, 9], [10, 50, 8], [40, 50, 7], [40, 0, 6]]), [at(0, 0), at(100, 0)], 5, null);
  expect(there.rocks).toEqual([0, 0]);
  expect(there.rockCount).toBe(1);
  expect(there.starts).toHaveLength(3);
  expect(there.distances[there.starts[1]!]).toBeCloseTo(40, 3);
});

test('points within it are kept as they are', () => {
  const kept = pathsInCorridor(paths([[10, 1, 9], [12, 1, 8], [14, 2, 7]]), [at(0, 0), at(100, 0)], 5, null);
  expect(kept.distances).toEqual([10, 12, 14]);
  expect(kept.elevations).toEqual([509, 508, 507]);
});

test('rocks beside it, beyond its ends, or left out by the filter have no part', () => {
  const three = paths([[10, 9, 9], [20, 9, 8]], [[-8, 0, 9], [-2, 0, 8]], [[10, 0, 9], [20, 0, 8]]);
  const line = [at(0, 0), at(100, 0)];
  expect(pathsInCorridor(three, line, 5, null)).toMatchObject({ rocks: [2], rockCount: 1 });
  expect(pathsInCorridor(three, line, 5, Uint8Array.of(1, 1, 0))).toMatchObject({ rocks: [], starts: [0], rockCount: 0 });
  expect(pathsInCorridor(three, line, 10, null).rocks).toEqual([0, 2]);
});
