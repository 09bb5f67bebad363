import { Ray, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { Frame } from './frame';
import { TerrainMaterial } from './terrainMaterial';
import { Tile } from './tile';

const columns = 4;
const rows = 3;
const heights = Float32Array.from([10, 12.3, 9, 8, 12, 14, 13.7, 10, 9, 15, 12, NaN]);
const diagonals = Uint8Array.from([1, 0, 0, 0, 1, 0]);
const cell: [number, number] = [10, 5];
const header = { origin: [1000, 2000, 0] as [number, number, number], cell, columns, rows };
const tile = new Tile(
  { header, arrays: { heights, around: new Float32Array(2 * (columns + rows)).fill(NaN), diagonals, materials: new Uint8Array((columns - 1) * (rows - 1)) } },
  new Frame([1000, 2000, 0]),
  cell,
  new TerrainMaterial(true),
);

/// The height as computed by the engine (src/talus/terrain/raster_surface.cpp).
function engineHeight(x: number, y: number): number | null {
  const [column, row] = [Math.floor(x / cell[0]), Math.floor(y / cell[1])];
  const [u, v] = [x / cell[0] - column, y / cell[1] - row];
  const at = (i: number, j: number) => heights[(row + j) * columns + column + i]!;
  const [sw, se, nw, ne] = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
  if (Number.isNaN(sw + se + nw + ne)) return null;
  if (diagonals[row * (columns - 1) + column] === 1)
    return u >= v ? sw + u * (se - sw) + v * (ne - se) : sw + v * (nw - sw) + u * (ne - nw);
  return u + v <= 1 ? sw + u * (se - sw) + v * (nw - sw) : ne + (1 - u) * (nw - ne) + (1 - v) * (se - ne);
}

test('a picked point has the height of the engine, and a hole has none', () => {
  const cuts = new Set<boolean>();
  for (let x = 0.7; x < 30; x += 1.3)
    for (let y = 0.3; y < 10; y += 0.7) {
      const expected = engineHeight(x, y);
      const found = tile.pick(new Ray(new Vector3(x, y, 100), new Vector3(0, 0, -1)));
      if (expected === null) expect(found).toBeNull();
      else expect(100 - found!.distance).toBeCloseTo(expected, 9);
      cuts.add(expected === null);
    }
  expect(cuts.size).toBe(2);
});

test('the centroid of each drawn triangle is on the surface', () => {
  const { geometry } = tile.mesh;
  const [node, height] = [geometry.getAttribute('node'), geometry.getAttribute('height')];
  const index = geometry.index!;
  let seen = 0;
  for (let k = 0; k < index.count; k += 3) {
    const corners = [0, 1, 2].map((c) => index.getX(k + c));
    const mean = (of: (corner: number) => number) => corners.reduce((sum, corner) => sum + of(corner), 0) / 3;
    const [i, j] = [mean((c) => node.getX(c)), mean((c) => node.getY(c))];
    // The skirt has no area on plan.
    const [a, b, c] = corners.map((corner) => [node.getX(corner), node.getY(corner)] as const);
    if ((b![0] - a![0]) * (c![1] - a![1]) === (b![1] - a![1]) * (c![0] - a![0])) continue;
    ++seen;
    expect(mean((corner) => height.getX(corner))).toBeCloseTo(engineHeight(i * cell[0], j * cell[1])!, 4);
  }
  expect(seen).toBe(2 * 5); // one of six cells is a hole
});

test('neighbours have the same slope at their common border', () => {
  const height = (i: number, j: number) => 100 + 3 * Math.sin(i) + 2 * Math.cos(1.7 * j) - 0.2 * i * j;
  const side = 4; // cells
  const slopes = (first: number) => {
    const nodes = Array.from({ length: side + 1 }, (_, k) => k);
    const row = (j: number) => nodes.map((i) => height(first + i, j));
    const column = (i: number) => nodes.map((j) => height(first + i, j));
    const made = new Tile(
      {
        header: { origin: [1000 + 10 * first, 2000, 0], cell, columns: side + 1, rows: side + 1 },
        arrays: {
          heights: Float32Array.from(nodes.flatMap(row)),
          around: Float32Array.from([row(-1), row(side + 1), column(-1), column(side + 1)].flat()),
          diagonals: new Uint8Array(side * side),
          materials: new Uint8Array(side * side),
        },
      },
      new Frame([1000, 2000, 0]),
      cell,
      new TerrainMaterial(true),
    );
    const gradient = made.mesh.geometry.getAttribute('gradient');
    // With the skirt, which has a node on each side.
    return (i: number) => nodes.flatMap((j) => [0, 1].map((axis) => gradient.getComponent((j + 1) * (side + 3) + i + 1, axis)));
  };
  expect(slopes(0)(side)).toEqual(slopes(side)(0));
  expect(slopes(0)(side)[0]).toBeCloseTo((height(side + 1, 0) - height(side - 1, 0)) / 20, 5);
});
