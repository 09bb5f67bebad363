import { expect, test } from 'vitest';
import type { DrawnBlocks } from '../paths/drawnBlocks';
import { hullVertices } from './hullVertices';

/// Two blocks: two triangles of one plane face, and one triangle.
const blocks = {
  drawn: Uint32Array.of(4, 7),
  cornerStarts: Uint32Array.of(0, 4, 7),
  triangleStarts: Uint32Array.of(0, 2, 3),
  corners: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 0, 2),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 0, 2, 1),
} as unknown as DrawnBlocks;
const { corners, normals, owners, sides } = hullVertices(blocks);

test('each triangle has its corners, its outward normal and its block', () => {
  expect([...corners].slice(9, 18)).toEqual([0, 0, 0, 1, 1, 0, 0, 1, 0]);
  expect([...corners].slice(18)).toEqual([0, 0, 0, 0, 0, 2, 0, 2, 0]);
  const normalOf = (vertex: number) => [...normals].slice(3 * vertex, 3 * vertex + 3).map((part) => part + 0);
  expect([0, 5, 6, 8].map(normalOf)).toEqual([[0, 0, 1], [0, 0, 1], [-1, 0, 0], [-1, 0, 0]]);
  expect([...owners]).toEqual([0, 0, 0, 0, 0, 0, 1, 1, 1]);
});

test('a side within a plane face is no edge', () => {
  // The side from corner 2 to corner 0 is across from corner 1, the second of the first triangle.
  expect([...sides].slice(0, 9)).toEqual([1, 1, 0, 0, 1, 0, 0, 1, 1]);
  expect([...sides].slice(18)).toEqual([1, 0, 0, 0, 1, 0, 0, 0, 1]);
});
