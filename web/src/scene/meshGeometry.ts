// Triangles as the scene draws them.

import { BufferAttribute, BufferGeometry, Vector3 } from 'three';

/// Assigns one material to each vertex. The shader takes the material of a triangle's last vertex, so triangles are
/// rotated, or get a duplicated vertex, until each ends in a vertex of its material.
function byLastVertex(positions: Float32Array, triangles: Uint32Array, materials: ArrayLike<number>) {
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

/// The geometry of triangles, shaded flat or smoothly.
export function meshGeometry(positions: Float32Array, triangles: Uint32Array, materials: ArrayLike<number>, isFlat: boolean): BufferGeometry {
  const { places, ground, index } = byLastVertex(positions, triangles, materials);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('ground', new BufferAttribute(ground, 1));
  geometry.setIndex(new BufferAttribute(index, 1));
  if (isFlat) geometry.setAttribute('normal', new BufferAttribute(new Int8Array(places.length), 3, true));
  else geometry.computeVertexNormals();
  return geometry;
}

/// About `most` of the vertices, evenly chosen.
export function someVertices(geometry: BufferGeometry, most: number): Vector3[] {
  const all = geometry.getAttribute('position');
  const step = Math.max(1, Math.floor(all.count / most));
  return Array.from({ length: Math.floor(all.count / step) }, (_, k) => new Vector3().fromBufferAttribute(all, k * step));
}
