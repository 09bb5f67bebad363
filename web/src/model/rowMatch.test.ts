import { describe, expect, test } from 'vitest';
import { rowsBefore, segmentsBefore } from './rowMatch';

const slope = [
  [0, 40],
  [10, 30],
  [20, 20],
  [30, 10],
  [40, 0],
];

describe('the segment that each one was', () => {
  test('a new vertex splits its own', () =>
    expect(segmentsBefore(slope, slope.toSpliced(2, 0, [15, 28]))).toEqual([0, 1, 1, 2, 3]));
  test('beyond an end it lengthens that one', () => {
    expect(segmentsBefore(slope, [...slope, [50, 0]])).toEqual([0, 1, 2, 3, 3]);
    expect(segmentsBefore(slope, [[-10, 50], ...slope])).toEqual([0, 0, 1, 2, 3]);
  });
  test('where one goes the one before it stays', () =>
    expect(segmentsBefore(slope, slope.toSpliced(2, 1))).toEqual([0, 1, 3]));
  test('at an end its segment goes', () => {
    expect(segmentsBefore(slope, slope.slice(1))).toEqual([1, 2, 3]);
    expect(segmentsBefore(slope, slope.slice(0, -1))).toEqual([0, 1, 2]);
  });
  test('as many vertices elsewhere change nothing', () =>
    expect(segmentsBefore(slope, slope.map(([x, z]) => [x! + 1000, z!]))).toEqual([0, 1, 2, 3]));
  test('of another table it is the one that lay nearest', () => {
    const finer = Array.from({ length: 9 }, (_, k) => [5 * k + 0.1, 40 - 5 * k]);
    expect(segmentsBefore(slope, finer)).toEqual([0, 0, 1, 1, 2, 2, 3, 3]);
  });
  test('two rows for one, between others that stay', () =>
    expect(segmentsBefore(slope, slope.toSpliced(2, 1, [12, 28], [24, 16]))).toEqual([0, 1, 1, 2, 3]));
  test('there are none before', () => expect(segmentsBefore([], [[0, 0]])).toEqual([]));
});

test('the row that each one was', () => {
  expect(rowsBefore(slope, slope.toSpliced(2, 0, [15, 28]))).toEqual([0, 1, null, 2, 3, 4]);
  expect(rowsBefore(slope, slope.toSpliced(2, 1))).toEqual([0, 1, 3, 4]);
  expect(rowsBefore(slope, slope.with(2, [15, 28]))).toEqual([0, 1, 2, 3, 4]);
});
