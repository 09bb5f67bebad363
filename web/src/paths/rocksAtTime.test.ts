import { expect, test } from 'vitest';
import type { DrawnPaths } from './drawnPaths';
import { RocksAtTime } from './rocksAtTime';

const paths = {
  starts: Uint32Array.of(0, 3, 5),
  times: Float32Array.of(0, 1, 3, 0, 2),
  speeds: Float32Array.of(0, 10, 20, 4, 8),
  positions: Float32Array.of(0, 0, 9, 1, 0, 8, 3, 2, 7, 5, 5, 5, 7, 5, 1),
} as unknown as DrawnPaths;

function speedsAt(rocks: RocksAtTime, time: number): number[] {
  const result = new Float32Array(2);
  rocks.find(time);
  rocks.read(paths.speeds, 1, result);
  return [...result];
}

test('positions are interpolated along the own trajectory', () => {
  const rocks = new RocksAtTime(paths);
  expect(speedsAt(rocks, 0)).toEqual([0, 4]);
  expect(speedsAt(rocks, 0.5)).toEqual([5, 5]);
  expect(speedsAt(rocks, 2)).toEqual([15, 8]);
});

test('a rock that has stopped stays', () => expect(speedsAt(new RocksAtTime(paths), 99)).toEqual([20, 8]));

test('the time may decrease', () => {
  const rocks = new RocksAtTime(paths);
  speedsAt(rocks, 3);
  expect(speedsAt(rocks, 0.5)).toEqual([5, 5]);
});

test('positions are shifted', () => {
  const rocks = new RocksAtTime(paths);
  const places = new Float32Array(6);
  rocks.find(2);
  rocks.read(paths.positions, 3, places, [100, 0, -1]);
  expect([...places]).toEqual([102, 1, 6.5, 107, 5, 0]);
});
