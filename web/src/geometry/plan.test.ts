import { expect, test } from 'vitest';
import { lengthOf } from './plan';

test('the length of a line is the sum of its pieces', () => {
  expect(lengthOf([[0, 0], [3, 4], [3, 5]])).toBe(6);
  expect(lengthOf([[1, 1]])).toBe(0);
});
