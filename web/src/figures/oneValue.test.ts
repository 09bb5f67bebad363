import { describe, expect, test } from 'vitest';
import { cumulativeCurve, shareAt } from './cumulative';
import { endsAround } from './oneValue';

describe('the axis of a single value', () => {
  test('has round ends', () => {
    expect(endsAround([6.499999999999999, 6.500000000000002])).toEqual({ min: 5.5, max: 7.5, interval: 0.5 });
    expect(endsAround([652375.5])).toEqual({ min: 652374, max: 652378, interval: 1 });
    expect(endsAround([-0.003])).toEqual({ min: -0.0034, max: -0.0026, interval: 0.0002 });
    expect(endsAround([0, 0])).toEqual({ min: -1, max: 1, interval: 0.5 });
  });
  test('is not needed if values differ or there are none', () => {
    expect(endsAround([6.5, 6.5001])).toBeNull();
    expect(endsAround([652375.5, 652375.6])).toBeNull();
    expect(endsAround([])).toBeNull();
  });
});

describe('the cumulative curve', () => {
  test('rises in steps over the whole axis', () =>
    expect(
      cumulativeCurve(
        [
          [1, 0.25],
          [3, 1],
        ],
        [0, 4],
      ),
    ).toEqual([
      [0, 0],
      [1, 0],
      [1, 25],
      [3, 25],
      [3, 100],
      [4, 100],
    ]));
  test('has one step for one value', () =>
    expect(cumulativeCurve([[6.5, 1]], [6, 7])).toEqual([
      [6, 0],
      [6.5, 0],
      [6.5, 100],
      [7, 100],
    ]));
  test('gives the share up to a value', () =>
    expect(
      [0, 1, 2, 3, 9].map((value) =>
        shareAt(
          [
            [1, 0.25],
            [3, 1],
          ],
          value,
        ),
      ),
    ).toEqual([0, 0.25, 0.25, 1, 1]));
});
