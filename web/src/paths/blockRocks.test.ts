import { expect, test } from 'vitest';
import { blockRocks } from './blockRocks';

const rocks = Uint32Array.from({ length: 10 }, (_, k) => 3 * k);

test('a few rocks are all blocks, whatever the filter', () =>
  expect(blockRocks(rocks, new Uint8Array(10), null, 10)).toEqual([...rocks]));

test('of many rocks, some are chosen evenly', () => expect(blockRocks(rocks, null, null, 5)).toEqual([0, 6, 12, 18, 24]));

test('of many rocks, those that pass are chosen', () => {
  const passes = Uint8Array.from(rocks, (_, k) => (k % 5 === 1 ? 1 : 0));
  expect(blockRocks(rocks, passes, null, 5)).toEqual([3, 18]);
});

test('the selected rock is a block', () => {
  expect(blockRocks(rocks, null, 9, 5)).toEqual([0, 6, 9, 12, 18]);
  expect(blockRocks(rocks, null, 12, 5)).toEqual([0, 6, 12, 18, 24]);
});
