import { Ray, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { Frame } from './frame';
import { MeshTile } from './meshTile';
import { TerrainMaterial } from './terrainMaterial';

const square = { positions: Float32Array.from([0, 0, 1, 10, 0, 1, 10, 10, 1, 0, 10, 1]), triangles: Uint32Array.from([0, 1, 2, 0, 2, 3]), materials: Uint8Array.from([0, 1]) };
const down = (x: number, y: number) => new Ray(new Vector3(x, y, 100), new Vector3(0, 0, -1));
const tileOf = (arrays: Record<string, Float32Array | Uint32Array | Uint8Array>) =>
  new MeshTile({ header: { origin: [1000, 2000, 50] }, arrays }, new Frame([1000, 2000, 0]), new TerrainMaterial(false));

test('the finest tile is picked with the number of the triangle in the mesh', () => {
  const tile = tileOf({ ...square, facets: Uint32Array.from([70, 71]) });
  expect(tile.pick(down(8, 2))).toEqual({ distance: 49, facet: 70 });
  expect(tile.pick(down(2, 8))).toEqual({ distance: 49, facet: 71 });
  expect(tile.pick(down(-5, 2))).toBeNull();
  expect(tile.box.min.z).toBe(51);
});

test('a coarse tile has no triangles of the mesh, an empty one nothing to pick', () => {
  expect(tileOf(square).pick(down(8, 2))).toEqual({ distance: 49 });
  const empty = tileOf({ positions: new Float32Array(0), triangles: new Uint32Array(0), materials: new Uint8Array(0) });
  expect(empty.box.isEmpty()).toBe(true);
  expect(empty.pick(down(8, 2))).toBeNull();
  expect(empty.samplePoints(5)).toEqual([]);
});
