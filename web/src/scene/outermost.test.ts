import { expect, test } from 'vitest';
import { outermost } from './outermost';

const inside = Array.from({ length: 500 }, (_, k) => ({ x: Math.sin(k), y: Math.cos(3 * k), z: Math.sin(7 * k) }));
const corners = Array.from({ length: 8 }, (_, k) => ({ x: k & 1 ? 2 : -2, y: k & 2 ? 2 : -2, z: k & 4 ? 2 : -2 }));

test('points inside are left out, corners are not', () => {
  const outer = outermost([...inside, ...corners]);
  expect(new Set(outer)).toEqual(new Set(corners));
});

test('few points are all kept, and points on a plane have outermost ones', () => {
  expect(outermost(corners)).toEqual(corners);
  const flat = inside.map(({ x, y }) => ({ x, y, z: 0 }));
  const outer = outermost(flat);
  expect(Math.max(...outer.map(({ x }) => x))).toBeCloseTo(Math.max(...flat.map(({ x }) => x)), 2);
  expect(outer.length).toBeLessThan(129);
});
