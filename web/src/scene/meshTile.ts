// A tile of a triangle mesh at one level of detail.

import { Box3, Mesh, Vector3, type BufferGeometry, type Ray } from 'three';
import type { Arrays } from '../api/arrays';
import type { Point3 } from '../api/types';
import type { Frame } from './frame';
import { meshGeometry, someVertices } from './meshGeometry';
import type { PickedTile, TerrainTile } from './terrain';
import type { TerrainMaterial } from './terrainMaterial';
import { TriangleBins } from './triangleBins';

export class MeshTile implements TerrainTile {
  readonly mesh: Mesh<BufferGeometry>;
  readonly box: Box3;
  readonly bytes: number;
  used = 0;
  private readonly positions: Float32Array;
  private readonly triangles: Uint32Array;
  private readonly facets: Uint32Array | undefined;
  private bins: TriangleBins | undefined;

  constructor({ header, arrays }: Arrays<{ origin: Point3 }>, frame: Frame, material: TerrainMaterial) {
    const shift = header.origin.map((value, k) => value - frame.base[k]!);
    this.positions = (arrays.positions as Float32Array).map((value, k) => value + shift[k % 3]!);
    this.triangles = arrays.triangles as Uint32Array;
    this.facets = arrays.facets as Uint32Array | undefined;
    this.box = new Box3().setFromArray(this.positions);
    const geometry = meshGeometry(this.positions, this.triangles, arrays.materials as Uint16Array, false);
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false; // tiles are chosen by their boxes
    // On the graphics card, and as much here; half as much again for picking.
    this.bytes = 2.5 * (28 * geometry.getAttribute('position').count + 4 * this.triangles.length);
  }

  pick(ray: Ray): PickedTile | null {
    if (this.triangles.length === 0 || !ray.intersectsBox(this.box.clone().expandByScalar(1e-3))) return null;
    this.bins ??= new TriangleBins(this.positions, this.triangles);
    const found = this.bins.pick(ray);
    return found && { distance: found.distance, ...(this.facets && { facet: this.facets[found.triangle]! }) };
  }

  samplePoints(most: number): Vector3[] {
    return this.triangles.length === 0 ? [] : someVertices(this.mesh.geometry, most * most);
  }

  dispose() {
    this.mesh.geometry.dispose();
  }
}
