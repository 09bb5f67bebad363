import { expect, test } from 'vitest';
import { onGround, partOf } from './foot';

const foot: [number, number, number][] = [[0, 0, 5], [10, 0, 10], [10, 10, 0]];
test('the part of a draped line between two distances', () => {
  expect(partOf(foot, 5, 15)).toEqual([[5, 0, 7.5], [10, 0, 10], [10, 5, 5]]);
  expect(partOf(foot, 0, 4)).toEqual([[0, 0, 5], [4, 0, 7]]);
  expect(partOf(foot, 12, 99)).toEqual([[10, 2, 8], [10, 10, 0]]);
});
test('points get the elevation of the nearest point of the line', () => {
  expect(onGround([[9, 1], [0, -1]], foot, 7)).toEqual([[9, 1, 10], [0, -1, 5]]);
  expect(onGround([[9, 1]], [], 7)).toEqual([[9, 1, 7]]);
});
