import { expect, test } from 'vitest';
import type { DrawnPaths } from './drawnPaths';
import { nearestRock } from './nearestRock';

const paths = { rocks: Uint32Array.of(4, 9), starts: Uint32Array.of(0, 2, 4) } as unknown as DrawnPaths;
const places = [[0, 0], [10, 0], [0, 6], [10, 6]] as const;
const at = (x: number, y: number, passes: Uint8Array | null = null) => nearestRock(paths, passes, (k) => places[k]!, [x, y], 4);

test('the nearer of two trajectories is picked', () => {
  expect(at(5, 2)).toBe(4);
  expect(at(5, 5)).toBe(9);
});
test('far from all trajectories no rock is picked', () => expect(at(5, 30)).toBe(null));
test('a rock excluded by the filter is not picked', () => expect(at(5, 5, Uint8Array.of(1, 0))).toBe(null));
test('trajectories are not connected with each other', () => expect(at(30, 3)).toBe(null));
