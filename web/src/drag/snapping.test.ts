import { expect, test } from 'vitest';
import type { Point3 } from '../api/types';
import { onGrid, snap, type Mark, type Target } from './snapping';

const mark = (x: number, y: number): Mark => ({ point: [x, 0, y] as Point3, pixel: [10 * x, 10 * y] });
const [a, b] = [mark(0, 0), mark(10, 0)];
const targets: Target[] = [
  { name: 'Fence', marks: [a] },
  { name: 'Fence', marks: [b] },
  { name: 'Fence', marks: [a, b] },
];

test('a vertex is preferred to a line', () => {
  expect(snap([8, 5], targets)).toEqual({ point: [0, 0, 0], to: 'a vertex of Fence' });
  expect(snap([95, 0], targets)?.point).toEqual([10, 0, 0]);
});
test('a place on a line is between its ends', () => {
  expect(snap([30, 6], targets)).toEqual({ point: [3, 0, 0], to: 'the line of Fence' });
  expect(snap([-20, 0], targets)).toBeNull();
});
test('what is far away is left', () => {
  expect(snap([30, 8], targets)).toBeNull();
  expect(snap([50, 50], [])).toBeNull();
});
test('a grid has round numbers', () => {
  expect(onGrid([1.26, 0.04, 7.5], 0.1)).toEqual([1.3, 0, 7.5]);
});
