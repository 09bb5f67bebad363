import { expect, test } from 'vitest';
import { hidesGround, type Covering } from './draped';

const terrain = { min: [0, 0, 5], max: [100, 50, 80] } as { min: [number, number, number]; max: [number, number, number] };
const photo = (east: number, opacity = 1): Covering => ({ opacity, found: { kind: 'raster', area: [[0, 0], [east, 50]], columns: 200, rows: 100 } });

test('an opaque picture as large as the terrain hides its colours', () => {
  expect(hidesGround([photo(100)], terrain)).toBe(true);
  expect(hidesGround([photo(99.7)], terrain)).toBe(true); // less than a pixel
  expect(hidesGround([photo(98)], terrain)).toBe(false);
  expect(hidesGround([photo(100, 0.9)], terrain)).toBe(false);
  expect(hidesGround([{ opacity: 1, found: { kind: 'vector' } }, { opacity: 1, found: null }], terrain)).toBe(false);
});

test('only the upper pictures, which are drawn, count', () => {
  const small = Array.from({ length: 4 }, () => photo(10));
  expect(hidesGround([photo(100), ...small], terrain)).toBe(false);
  expect(hidesGround([photo(100), ...small.slice(1)], terrain)).toBe(true);
});
