import { describe, expect, test } from 'vitest';
import { rowsBefore, segmentsBefore } from './rowMatch';

const slope = [
  [0, 40],
  [10, 30],
  [20, 20],
  [30, 10],
  [40, 0],
];

describe('the former segment of each segment', () => {
  test('a new vertex splits its segment', () =>
    expect(segmentsBefore(slope, slope.toSpliced(2, 0, [15, 28]))).toEqual([0, 1, 1, 2, 3]));
  test('a new vertex beyond an end extends the last segment', () => {
    expect(segmentsBefore(slope, [...slope, [50, 0]])).toEqual([0, 1, 2, 3, 3]);
    expect(segmentsBefore(slope, [[-10, 50], ...slope])).toEqual([0, 0, 1, 2, 3]);
  });
  test('deleting a vertex keeps the segment before it', () =>
    expect(segmentsBefore(slope, slope.toSpliced(2, 1))).toEqual([0, 1, 3]));
  test('deleting an end vertex deletes its segment', () => {
    expect(segmentsBefore(slope, slope.slice(1))).toEqual([1, 2, 3]);
    expect(segmentsBefore(slope, slope.slice(0, -1))).toEqual([0, 1, 2]);
  });
  test('moving all vertices keeps all segments', () =>
    expect(segmentsBefore(slope, slope.map(([x, z]) => [x! + 1000, z!]))).toEqual([0, 1, 2, 3]));
  test('in a replaced table it is the nearest former segment', () => {
    const finer = Array.from({ length: 9 }, (_, k) => [5 * k + 0.1, 40 - 5 * k]);
    expect(segmentsBefore(slope, finer)).toEqual([0, 0, 1, 1, 2, 2, 3, 3]);
  });
  test('one row is replaced by two between unchanged rows', () =>
    expect(segmentsBefore(slope, slope.toSpliced(2, 1, [12, 28], [24, 16]))).toEqual([0, 1, 1, 2, 3]));
  test('there are no former segments', () => expect(segmentsBefore([], [[0, 0]])).toEqual([]));
});

test('the former index of each row', () => {
  expect(rowsBefore(slope, slope.toSpliced(2, 0, [15, 28]))).toEqual([0, 1, null, 2, 3, 4]);
  expect(rowsBefore(slope, slope.toSpliced(2, 1))).toEqual([0, 1, 3, 4]);
  expect(rowsBefore(slope, slope.with(2, [15, 28]))).toEqual([0, 1, 2, 3, 4]);
});
