// A square piece of a raster terrain, at one level of detail.

import { Box3, BufferAttribute, BufferGeometry, Mesh, Sphere, Vector3, type Ray } from 'three';
import type { Arrays } from '../api/arrays';
import type { Point3 } from '../api/types';
import type { Frame } from './frame';
import { meet, walk, type PlanGrid } from './gridWalk';
import type { TerrainMaterial } from './terrainMaterial';

export interface TileHeader {
  origin: Point3;
  cell: [number, number];
  columns: number;
  rows: number;
}

const sharedNodes = new Map<string, BufferAttribute>();
const sharedIndex = new Map<string, BufferAttribute>();

/// The places of a tile's nodes in cells, with a rim around them that hangs down, so that tiles of different levels show
/// no cracks between them.
function nodesOf(columns: number, rows: number): BufferAttribute {
  const key = `${columns} ${rows}`;
  let nodes = sharedNodes.get(key);
  if (!nodes) {
    const array = new Float32Array(2 * (columns + 2) * (rows + 2));
    let k = 0;
    for (let j = -1; j <= rows; ++j)
      for (let i = -1; i <= columns; ++i) {
        array[k++] = Math.min(columns - 1, Math.max(0, i));
        array[k++] = Math.min(rows - 1, Math.max(0, j));
      }
    nodes = new BufferAttribute(array, 2);
    sharedNodes.set(key, nodes);
  }
  return nodes;
}

/// Both triangles of each cell; those with a corner in a hole are left out.
function indexOf(columns: number, rows: number, heights: Float32Array, holes: boolean): BufferAttribute {
  const key = `${columns} ${rows}`;
  const known = sharedIndex.get(key);
  if (known && !holes) return known;
  const [across, along] = [columns + 2, rows + 2];
  const array = new Uint32Array(6 * (across - 1) * (along - 1));
  let k = 0;
  const add = (a: number, b: number, c: number) => {
    if (holes && Number.isNaN(heights[a]! + heights[b]! + heights[c]!)) return;
    array[k++] = a;
    array[k++] = b;
    array[k++] = c;
  };
  for (let j = 0; j + 1 < along; ++j)
    for (let i = 0; i + 1 < across; ++i) {
      const a = j * across + i;
      add(a, a + 1, a + across + 1);
      add(a, a + across + 1, a + across);
    }
  const index = new BufferAttribute(array.subarray(0, k), 1);
  if (!holes) sharedIndex.set(key, index);
  return index;
}

export class Tile {
  readonly mesh: Mesh;
  readonly box: Box3;
  readonly bytes: number;
  used = 0;
  private readonly heights: Float32Array;
  private readonly grid: PlanGrid;
  private readonly z: number;

  constructor(
    { header, arrays }: Arrays<TileHeader>,
    frame: Frame,
    readonly cell: [number, number],
    material: TerrainMaterial,
  ) {
    const { columns, rows } = header;
    this.heights = arrays.heights as Float32Array;
    const [x, y, z] = header.origin.map((value, k) => value - frame.base[k]!) as Point3;
    this.z = z;
    this.grid = { x, y, dx: cell[0], dy: cell[1], columns: columns - 1, rows: rows - 1 };

    const [across, along] = [columns + 2, rows + 2];
    const height = new Float32Array(across * along);
    const gradient = new Float32Array(2 * height.length);
    const ground = new Uint8Array(height.length);
    let [low, high, holes, rough] = [Infinity, -Infinity, false, 0];
    const at = (i: number, j: number) => this.heights[j * columns + i]!;
    // The slope between neighbours on both sides, or on the one that there is.
    const rise = (before: number, here: number, after: number, step: number) => {
      const [b, a] = [Number.isNaN(before) ? here : before, Number.isNaN(after) ? here : after];
      const steps = (b === here && Number.isNaN(before) ? 0 : 1) + (Number.isNaN(after) ? 0 : 1);
      return steps === 0 ? 0 : (a - b) / (steps * step);
    };
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        const here = at(i, j);
        const k = (j + 1) * across + i + 1;
        height[k] = here;
        // Materials are of cells: a node has that of the cell north-east of it, if there is one.
        const cellOf = Math.min(j, rows - 2) * (columns - 1) + Math.min(i, columns - 2);
        ground[k] = (arrays.materials?.[cellOf] ?? 0) as number;
        if (Number.isNaN(here)) {
          holes = true;
          continue;
        }
        low = Math.min(low, here);
        high = Math.max(high, here);
        const gx = rise(i > 0 ? at(i - 1, j) : NaN, here, i + 1 < columns ? at(i + 1, j) : NaN, cell[0]);
        const gy = rise(j > 0 ? at(i, j - 1) : NaN, here, j + 1 < rows ? at(i, j + 1) : NaN, cell[1]);
        gradient[2 * k] = gx;
        gradient[2 * k + 1] = gy;
        rough = Math.max(rough, Math.abs(gx) * cell[0], Math.abs(gy) * cell[1]);
      }
    const drop = Math.min(rough, 0.25 * (high - low)) + 0.02 * cell[0];
    const copy = (to: number, from: number) => {
      height[to] = height[from]! - drop;
      gradient[2 * to] = gradient[2 * from]!;
      gradient[2 * to + 1] = gradient[2 * from + 1]!;
      ground[to] = ground[from]!;
    };
    for (let i = 1; i <= columns; ++i) {
      copy(i, across + i);
      copy((along - 1) * across + i, (along - 2) * across + i);
    }
    for (let j = 0; j < along; ++j) {
      const row = Math.min(rows, Math.max(1, j));
      const lowered = j === row ? drop : 0;
      for (const [to, from] of [
        [j * across, j * across + 1],
        [j * across + across - 1, j * across + across - 2],
      ] as const) {
        copy(to, from);
        height[to]! += drop - lowered;
      }
    }

    const geometry = new BufferGeometry();
    geometry.setAttribute('node', nodesOf(columns, rows));
    geometry.setAttribute('height', new BufferAttribute(height, 1));
    geometry.setAttribute('gradient', new BufferAttribute(gradient, 2));
    geometry.setAttribute('ground', new BufferAttribute(ground, 1));
    geometry.setIndex(indexOf(columns, rows, height, holes));
    if (!(low <= high)) [low, high] = [0, 0];
    this.box = new Box3(
      new Vector3(x, y, z + low),
      new Vector3(x + cell[0] * (columns - 1), y + cell[1] * (rows - 1), z + high),
    );
    geometry.boundingSphere = new Sphere(new Vector3(0, 0, 0), Infinity);
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.position.set(x, y, z);
    this.mesh.scale.set(cell[0], cell[1], 1);
    this.bytes = 13 * height.length + (holes ? 24 * height.length : 0);
  }

  pick(ray: Ray): number | null {
    if (!ray.intersectsBox(this.box.clone().expandByScalar(1e-3))) return null;
    const { x, y, dx, dy, columns } = this.grid;
    const corners = new Float64Array(12);
    return walk(ray, this.grid, (i, j) => {
      for (let k = 0; k < 4; ++k) {
        const [c, r] = [i + (k % 2), j + (k >> 1)];
        corners[3 * k] = x + c * dx;
        corners[3 * k + 1] = y + r * dy;
        corners[3 * k + 2] = this.z + this.heights[r * (columns + 1) + c]!;
      }
      return meet(ray, corners, 0, 3, 9) ?? meet(ray, corners, 0, 9, 6);
    });
  }

  dispose() {
    // The shared buffers stay for other tiles.
    const { geometry } = this.mesh;
    geometry.deleteAttribute('node');
    if (sharedIndex.get(`${this.grid.columns + 1} ${this.grid.rows + 1}`) === geometry.index) geometry.setIndex(null);
    geometry.dispose();
  }
}
