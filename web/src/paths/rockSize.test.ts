import { expect, test } from 'vitest';
import { drawnRadius, leastRadius, markRadius, meanSpacing } from './rockSize';

test('a near rock has its true size', () => {
  expect(drawnRadius(0.5, 2, 40, 3)).toBe(20);
  expect(drawnRadius(2, 2, 40, 3)).toBe(80);
});
test('a distant rock has a minimum size that grows with its radius', () => {
  expect(drawnRadius(2, 2, 0.01, 3)).toBe(3);
  expect(drawnRadius(0.2, 2, 0.01, 3)).toBeLessThan(drawnRadius(1, 2, 0.01, 3));
  expect(drawnRadius(0, 2, 0.01, 3)).toBeGreaterThan(1.5);
  expect(drawnRadius(1, 0, 0.01, 3)).toBe(3);
});
test('the more rocks, the smaller they are drawn', () => expect(leastRadius(10_000)).toBeLessThan(leastRadius(50)));
test('marks of adjacent points do not overlap', () => {
  for (const spacing of [4, 9, 20, 1e9]) expect(2 * markRadius(spacing, 5)).toBeLessThan(spacing);
});
test('the mean spacing is along a line or over an area', () => {
  expect(meanSpacing([[0, 0], [10, 0], [20, 0]])).toBe(10);
  const grid = Array.from({ length: 100 }, (_, k) => [k % 10, Math.floor(k / 10)]);
  expect(meanSpacing(grid)).toBeCloseTo(0.9, 5);
  expect(meanSpacing([[1, 2]])).toBe(Infinity);
});
