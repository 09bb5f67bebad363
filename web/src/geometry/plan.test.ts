import { expect, test } from 'vitest';
import { rounded } from './plan';

test('clicked coordinates are rounded to millimetres or centimetres', () => {
  expect(rounded(12.34567, 50)).toBe(12.346);
  expect(rounded(652375.98765, 5000)).toBe(652375.99);
  expect(rounded(207.0941, 0)).toBe(207.09);
});
