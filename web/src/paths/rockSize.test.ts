import { expect, test } from 'vitest';
import { drawnRadius, leastRadius, markRadius, meanSpacing } from './rockSize';

test('near by a rock is as large as it is', () => {
  expect(drawnRadius(0.5, 2, 40, 3)).toBe(20);
  expect(drawnRadius(2, 2, 40, 3)).toBe(80);
});
test('far away it is still seen, and a larger rock is larger', () => {
  expect(drawnRadius(2, 2, 0.01, 3)).toBe(3);
  expect(drawnRadius(0.2, 2, 0.01, 3)).toBeLessThan(drawnRadius(1, 2, 0.01, 3));
  expect(drawnRadius(0, 2, 0.01, 3)).toBeGreaterThan(1.5);
  expect(drawnRadius(1, 0, 0.01, 3)).toBe(3);
});
test('many rocks are drawn smaller than few', () => expect(leastRadius(10_000)).toBeLessThan(leastRadius(50)));
test('marks of places near each other do not run together', () => {
  for (const apart of [4, 9, 20, 1e9]) expect(2 * markRadius(apart, 5)).toBeLessThan(apart);
});
test('spacing is along a line, or over an area', () => {
  expect(meanSpacing([[0, 0], [10, 0], [20, 0]])).toBe(10);
  const grid = Array.from({ length: 100 }, (_, k) => [k % 10, Math.floor(k / 10)]);
  expect(meanSpacing(grid)).toBeCloseTo(0.9, 5);
  expect(meanSpacing([[1, 2]])).toBe(Infinity);
});
