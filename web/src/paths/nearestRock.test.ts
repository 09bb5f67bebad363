import { expect, test } from 'vitest';
import type { DrawnPaths } from './drawnPaths';
import { nearestRock } from './nearestRock';

const paths = { rocks: Uint32Array.of(4, 9), starts: Uint32Array.of(0, 2, 4) } as unknown as DrawnPaths;
const places = [[0, 0], [10, 0], [0, 6], [10, 6]] as const;
const at = (x: number, y: number, passes: Uint8Array | null = null) => nearestRock(paths, passes, (k) => places[k]!, [x, y], 4);

test('the nearer of two paths is meant', () => {
  expect(at(5, 2)).toBe(4);
  expect(at(5, 5)).toBe(9);
});
test('far from all of them none is', () => expect(at(5, 30)).toBe(null));
test('one that the filter leaves out is not', () => expect(at(5, 5, Uint8Array.of(1, 0))).toBe(null));
test('between two paths there is no line', () => expect(at(30, 3)).toBe(null));
