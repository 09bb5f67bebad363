import { expect, test } from 'vitest';
import { distanceToLine } from './nearness';

test('the distance is perpendicular to the line, or to the nearer end beyond it', () => {
  expect(distanceToLine([5, 3], [0, 0], [10, 0])).toBe(3);
  expect(distanceToLine([13, 4], [0, 0], [10, 0])).toBe(5);
  expect(distanceToLine([-3, -4], [0, 0], [10, 0])).toBe(5);
});
test('a line without length is a point', () => expect(distanceToLine([3, 4], [0, 0], [0, 0])).toBe(5));
