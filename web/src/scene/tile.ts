// A tile of a raster terrain at one level of detail.

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  Mesh,
  NearestFilter,
  RedFormat,
  Sphere,
  Vector3,
  type Ray,
} from 'three';
import type { Arrays, NumberArray } from '../api/arrays';
import type { Point3 } from '../api/types';
import { cut, cutCells, thinCells, trianglesOf } from './cellCut';
import type { Frame } from './frame';
import { meet, walk, type PlanGrid } from './gridWalk';
import type { PickedTile, TerrainTile } from './terrain';
import type { TerrainMaterial } from './terrainMaterial';

export interface TileHeader {
  origin: Point3;
  cell: [number, number];
  columns: number;
  rows: number;
}

const thinSteps = [8, 4]; // nodes; sides of tiles have a multiple of them, except at the border of the raster

const sharedNodes = new Map<string, BufferAttribute>();

/// The positions of a tile's nodes in cells, with a skirt around them that hides cracks between tiles of different levels.
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

/// The material of each cell for the shader. There are up to 256; colours repeat long before.
function kindsOf(columns: number, rows: number, materials: NumberArray | undefined): DataTexture {
  const made = new DataTexture(Uint8Array.from(materials ?? new Uint8Array(columns * rows)), columns, rows, RedFormat);
  made.magFilter = made.minFilter = NearestFilter;
  made.unpackAlignment = 1;
  made.needsUpdate = true;
  return made;
}

const meetCorners = (ray: Ray, corners: Float64Array, [a, b, c]: readonly [number, number, number]) =>
  meet(ray, corners, 3 * a, 3 * b, 3 * c);

export class Tile implements TerrainTile {
  readonly mesh: Mesh;
  readonly box: Box3;
  readonly bytes: number;
  used = 0;
  private readonly whole: BufferAttribute;
  private readonly thinned: Record<number, BufferAttribute> = {};
  private readonly indexOf: (step: number) => BufferAttribute;
  private readonly heights: Float32Array;
  /// Per cell, 1 if it is cut from south-west to north-east.
  private readonly diagonals: NumberArray;
  private readonly grid: PlanGrid;
  private readonly z: number;
  /// The material of each cell.
  private readonly kinds: DataTexture;

  constructor(
    { header, arrays }: Arrays<TileHeader>,
    frame: Frame,
    readonly cell: [number, number],
    material: TerrainMaterial,
  ) {
    const { columns, rows } = header;
    this.heights = arrays.heights as Float32Array;
    this.diagonals = arrays.diagonals!;
    const [x, y, z] = header.origin.map((value, k) => value - frame.base[k]!) as Point3;
    this.z = z;
    this.grid = { x, y, dx: cell[0], dy: cell[1], columns: columns - 1, rows: rows - 1 };

    const [across, along] = [columns + 2, rows + 2];
    const height = new Float32Array(across * along);
    const gradient = new Float32Array(2 * height.length);
    let [low, high, rough] = [Infinity, -Infinity, 0];
    // A step beyond the tile, so that slopes are those of the whole terrain: neighbours must have the same at their border.
    const around = arrays.around as Float32Array;
    const at = (i: number, j: number) => {
      if (j < 0) return around[i]!;
      if (j === rows) return around[columns + i]!;
      if (i < 0) return around[2 * columns + j]!;
      return i === columns ? around[2 * columns + rows + j]! : this.heights[j * columns + i]!;
    };
    // The slope between both neighbours, or to the only one.
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
        if (Number.isNaN(here)) continue;
        low = Math.min(low, here);
        high = Math.max(high, here);
        const gx = rise(at(i - 1, j), here, at(i + 1, j), cell[0]);
        const gy = rise(at(i, j - 1), here, at(i, j + 1), cell[1]);
        gradient[2 * k] = gx;
        gradient[2 * k + 1] = gy;
        rough = Math.max(rough, Math.abs(gx) * cell[0], Math.abs(gy) * cell[1]);
      }
    const drop = Math.min(rough, 0.25 * (high - low)) + 0.02 * cell[0];
    const copy = (to: number, from: number) => {
      height[to] = height[from]! - drop;
      gradient[2 * to] = gradient[2 * from]!;
      gradient[2 * to + 1] = gradient[2 * from + 1]!;
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
    this.whole = new BufferAttribute(cutCells(height, across, along, (i, j) => this.isNorthEast(i - 1, j - 1)), 1);
    geometry.setIndex(this.whole);
    this.indexOf = (step) => new BufferAttribute(thinCells(height, across, along, step), 1);
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
    this.kinds = kindsOf(columns - 1, rows - 1, arrays.materials);
    this.mesh.userData.textures = [this.kinds];
    this.mesh.onBeforeRender = () => {
      material.uniforms.cellKinds.value = this.kinds;
      material.uniformsNeedUpdate = true;
    };
    this.bytes = 16 * height.length + 4 * geometry.index!.count + 2 * (columns - 1) * (rows - 1);
  }

  thin(cells: number) {
    const step = thinSteps.find((each) => each <= cells);
    if (step && !this.thinned[step]) this.thinned[step] = this.indexOf(step);
    this.mesh.geometry.setIndex(step ? this.thinned[step]! : this.whole);
  }

  /// Of a cell; of one in the skirt, any.
  private isNorthEast(column: number, row: number): boolean {
    return this.diagonals[row * this.grid.columns + column] === 1;
  }

  pick(ray: Ray): PickedTile | null {
    if (!ray.intersectsBox(this.box.clone().expandByScalar(1e-3))) return null;
    const { x, y, dx, dy, columns } = this.grid;
    const corners = new Float64Array(12);
    const distance = walk(ray, this.grid, (i, j) => {
      const way = cut(this.heights, columns + 1, i, j, this.isNorthEast(i, j));
      if (way === 'hole') return null;
      for (let k = 0; k < 4; ++k) {
        const [c, r] = [i + (k % 2), j + (k >> 1)];
        corners[3 * k] = x + c * dx;
        corners[3 * k + 1] = y + r * dy;
        corners[3 * k + 2] = this.z + this.heights[r * (columns + 1) + c]!;
      }
      const [first, second] = trianglesOf[way];
      const [a, b] = [meetCorners(ray, corners, first), meetCorners(ray, corners, second)];
      return a === null || b === null ? (a ?? b) : Math.min(a, b);
    });
    return distance === null ? null : { distance };
  }

  /// Nodes with data, at most about `most` along each side.
  samplePoints(most: number): Vector3[] {
    const { x, y, dx, dy, columns, rows } = this.grid;
    const list: Vector3[] = [];
    // Includes both edges.
    const some = (count: number) => Array.from({ length: Math.min(most, count) + 1 }, (_, k) => Math.round((k * count) / Math.min(most, count)));
    for (const j of some(rows))
      for (const i of some(columns)) {
        const height = this.heights[j * (columns + 1) + i]!;
        if (!Number.isNaN(height)) list.push(new Vector3(x + i * dx, y + j * dy, this.z + height));
      }
    return list;
  }

  dispose() {
    // The nodes are shared with other tiles.
    const { geometry } = this.mesh;
    geometry.deleteAttribute('node');
    geometry.dispose();
    this.kinds.dispose();
  }
}
