// A terrain of arbitrary triangles.

import { BufferAttribute, BufferGeometry, Mesh, Vector3, type Ray } from 'three';
import { getArrays } from '../api/client';
import type { Point3 } from '../api/types';
import type { Frame } from './frame';
import { meet, walk, type PlanGrid } from './gridWalk';
import type { Hit, Terrain } from './terrain';
import type { TerrainMaterial } from './terrainMaterial';

/// Assigns one material to each vertex. The shader takes the material of a triangle's last vertex, so triangles are
/// rotated, or get a duplicated vertex, until each ends in a vertex of its material.
function byLastVertex(positions: Float32Array, triangles: Uint32Array, materials: Uint16Array) {
  const count = positions.length / 3;
  const kinds = new Int32Array(count).fill(-1);
  const index = new Uint32Array(triangles.length);
  const copies: number[] = [];
  const copyKinds: number[] = [];
  for (let t = 0; t < materials.length; ++t) {
    const kind = materials[t]!;
    let last = -1;
    for (let k = 0; k < 3 && last < 0; ++k) {
      const v = triangles[3 * t + k]!;
      if (kinds[v] === kind || kinds[v] === -1) last = k;
    }
    const position = last < 0 ? 2 : last;
    let end = triangles[3 * t + position]!;
    if (last < 0) {
      copies.push(end);
      copyKinds.push(kind);
      end = count + copies.length - 1;
    } else kinds[end] = kind;
    index.set([triangles[3 * t + ((position + 1) % 3)]!, triangles[3 * t + ((position + 2) % 3)]!, end], 3 * t);
  }
  const places = new Float32Array(3 * (count + copies.length));
  places.set(positions);
  const ground = new Float32Array(count + copies.length);
  ground.set(kinds);
  copies.forEach((v, k) => {
    places.set(positions.subarray(3 * v, 3 * v + 3), 3 * (count + k));
    ground[count + k] = copyKinds[k]!;
  });
  return { places, ground, index };
}

/// A grid on plan with the triangles that overlap each cell.
class Bins {
  readonly grid: PlanGrid;
  private readonly starts: Uint32Array;
  private readonly members: Uint32Array;

  constructor(
    private readonly positions: Float32Array,
    private readonly triangles: Uint32Array,
  ) {
    let [x, y, X, Y] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < positions.length; k += 3) {
      x = Math.min(x, positions[k]!);
      X = Math.max(X, positions[k]!);
      y = Math.min(y, positions[k + 1]!);
      Y = Math.max(Y, positions[k + 1]!);
    }
    const count = triangles.length / 3;
    const side = Math.max(1e-6, Math.sqrt(((X - x) * (Y - y)) / Math.max(1, count / 2)));
    const columns = Math.min(2048, Math.max(1, Math.ceil((X - x) / side)));
    const rows = Math.min(2048, Math.max(1, Math.ceil((Y - y) / side)));
    this.grid = { x, y, dx: Math.max(1e-9, (X - x) / columns), dy: Math.max(1e-9, (Y - y) / rows), columns, rows };
    this.starts = new Uint32Array(columns * rows + 1);
    this.eachCell((cell) => void this.starts[cell + 1]!++);
    for (let k = 0; k < columns * rows; ++k) this.starts[k + 1]! += this.starts[k]!;
    const next = this.starts.slice();
    this.members = new Uint32Array(this.starts.at(-1)!);
    this.eachCell((cell, t) => void (this.members[next[cell]!++] = t));
  }

  private eachCell(visit: (cell: number, triangle: number) => void) {
    const { x, y, dx, dy, columns, rows } = this.grid;
    const p = this.positions;
    const within = (value: number, count: number) => Math.min(count - 1, Math.max(0, Math.floor(value)));
    for (let t = 0; t < this.triangles.length / 3; ++t) {
      const [a, b, c] = [3 * this.triangles[3 * t]!, 3 * this.triangles[3 * t + 1]!, 3 * this.triangles[3 * t + 2]!];
      const i0 = within((Math.min(p[a]!, p[b]!, p[c]!) - x) / dx, columns);
      const i1 = within((Math.max(p[a]!, p[b]!, p[c]!) - x) / dx, columns);
      const j0 = within((Math.min(p[a + 1]!, p[b + 1]!, p[c + 1]!) - y) / dy, rows);
      const j1 = within((Math.max(p[a + 1]!, p[b + 1]!, p[c + 1]!) - y) / dy, rows);
      for (let j = j0; j <= j1; ++j) for (let i = i0; i <= i1; ++i) visit(j * columns + i, t);
    }
  }

  pick(ray: Ray): { distance: number; triangle: number } | null {
    let triangle = -1;
    let least = Infinity;
    const slack = 1e-6 * (this.grid.dx + this.grid.dy);
    const distance = walk(ray, this.grid, (column, row, _, leave) => {
      const cell = row * this.grid.columns + column;
      for (let k = this.starts[cell]!; k < this.starts[cell + 1]!; ++k) {
        const t = this.members[k]!;
        const [a, b, c] = [this.triangles[3 * t]!, this.triangles[3 * t + 1]!, this.triangles[3 * t + 2]!];
        const found = meet(ray, this.positions, 3 * a, 3 * b, 3 * c);
        if (found !== null && found < least) [least, triangle] = [found, t];
      }
      return least <= leave + slack ? least : null;
    });
    const at = distance ?? (triangle >= 0 ? least : null);
    return at === null ? null : { distance: at, triangle };
  }
}

export class MeshTerrain implements Terrain {
  readonly object: Mesh;
  private readonly bins: Bins;

  constructor(positions: Float32Array, triangles: Uint32Array, materials: Uint16Array, material: TerrainMaterial) {
    const { places, ground, index } = byLastVertex(positions, triangles, materials);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(places, 3));
    geometry.setAttribute('ground', new BufferAttribute(ground, 1));
    geometry.setIndex(new BufferAttribute(index, 1));
    // A few facets are shaded flat, many smoothly.
    const faceted = materials.length < 4000;
    material.uniforms.faceted.value = faceted;
    if (!faceted) geometry.computeVertexNormals();
    else geometry.setAttribute('normal', new BufferAttribute(new Int8Array(places.length), 3, true));
    this.object = new Mesh(geometry, material);
    this.bins = new Bins(positions, triangles);
  }

  static async of(model: string, frame: Frame, material: TerrainMaterial, signal: AbortSignal): Promise<MeshTerrain> {
    const { header, arrays } = await getArrays<{ origin: Point3 }>(`/api/models/${model}/mesh`, signal);
    const positions = (arrays.positions as Float32Array).slice();
    const shift = header.origin.map((value, k) => value - frame.base[k]!);
    for (let k = 0; k < positions.length; ++k) positions[k]! += shift[k % 3]!;
    return new MeshTerrain(positions, arrays.triangles as Uint32Array, arrays.materials as Uint16Array, material);
  }

  select() {}

  pick(ray: Ray): Hit | null {
    const found = this.bins.pick(ray);
    if (!found) return null;
    return { point: ray.at(found.distance, new Vector3()), distance: found.distance, facet: found.triangle };
  }

  samplePoints(): Vector3[] {
    const all = this.object.geometry.getAttribute('position');
    const step = Math.max(1, Math.floor(all.count / 600));
    return Array.from({ length: Math.floor(all.count / step) }, (_, k) => new Vector3().fromBufferAttribute(all, k * step));
  }

  dispose() {
    this.object.geometry.dispose();
  }
}
