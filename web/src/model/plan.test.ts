import { expect, test } from 'vitest';
import { isWithin, rounded } from './plan';

test('places are rounded finer than anyone points', () => {
  expect(rounded(12.34567, 50)).toBe(12.346);
  expect(rounded(652375.98765, 5000)).toBe(652375.99);
  expect(rounded(207.0941, 0)).toBe(207.09);
});

test('within a polygon on plan, whose corners need not repeat the first', () => {
  const ring: [number, number, number][] = [
    [0, 0, 0],
    [10, 0, 5],
    [10, 10, 0],
    [5, 5, 0],
    [0, 10, 0],
  ];
  expect(isWithin([2, 2], ring)).toBe(true);
  expect(isWithin([5, 8], ring)).toBe(false); // in the notch
  expect(isWithin([-1, 5], ring)).toBe(false);
  expect(isWithin([11, 5], ring)).toBe(false);
});
