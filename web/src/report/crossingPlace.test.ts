import { expect, test } from 'vitest';
import { crossingPlace } from './crossingPlace';

const line = [[0, 0], [10, 0], [10, 10]] as const;
const down = (x: number) => [{ x, y: 5 }, { x, y: -5 }];

test('a line is crossed at the middle of its crossings', () => {
  expect(crossingPlace(line, [down(1), down(3), down(8), down(-20)])).toEqual({ x: 3, y: 0 });
  expect(crossingPlace(line, [[{ x: 5, y: 4 }, { x: 15, y: 4 }]])).toEqual({ x: 10, y: expect.closeTo(4, 9) });
});

test('a line that no trajectory crosses has its middle, a point itself', () => {
  expect(crossingPlace(line, [down(-20)])).toEqual({ x: 10, y: 0 });
  expect(crossingPlace([[7, 3]], [down(7)])).toEqual({ x: 7, y: 3 });
});
