// A terrain of arbitrary triangles.

import { Mesh, Vector3, type Ray } from 'three';
import { getArrays } from '../api/client';
import type { Point3 } from '../api/types';
import type { Frame } from './frame';
import { meshGeometry, someVertices } from './meshGeometry';
import type { Hit, Terrain } from './terrain';
import type { TerrainMaterial } from './terrainMaterial';
import { TriangleBins } from './triangleBins';

export class MeshTerrain implements Terrain {
  readonly object: Mesh;
  private readonly bins: TriangleBins;

  constructor(positions: Float32Array, triangles: Uint32Array, materials: Uint16Array, material: TerrainMaterial) {
    // A few facets are shaded flat, many smoothly.
    const isFlat = materials.length < 4000;
    material.uniforms.faceted.value = isFlat;
    this.object = new Mesh(meshGeometry(positions, triangles, materials, isFlat), material);
    this.bins = new TriangleBins(positions, triangles);
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
    return someVertices(this.object.geometry, 600);
  }

  dispose() {
    this.object.geometry.dispose();
  }
}
