// The hulls of all blocks as separate triangles, each with its own normal: blocks have faces and edges.

import type { DrawnBlocks } from '../paths/drawnBlocks';

export interface HullVertices {
  // For each vertex, three per triangle:
  corners: Float32Array<ArrayBuffer>; // in the frame of the block, three numbers, m
  normals: Float32Array<ArrayBuffer>; // unit, outwards
  owners: Float32Array<ArrayBuffer>; // the number of the block
  /// Three numbers, one for each side of the triangle: 0 on it, 1 at the corner across from it; 1 everywhere if the
  /// side only divides a plane face.
  sides: Float32Array<ArrayBuffer>;
}

const flat = Math.cos((2 * Math.PI) / 180); // faces that bend less are one

type Triangle = [number, number, number];

function normalOf(corners: Float32Array, [a, b, c]: Triangle): Triangle {
  const side = (to: number, axis: number) => corners[3 * to + axis]! - corners[3 * a + axis]!;
  const normal = [0, 1, 2].map((axis) => {
    const [y, z] = [(axis + 1) % 3, (axis + 2) % 3];
    return side(b, y) * side(c, z) - side(b, z) * side(c, y);
  });
  const length = Math.hypot(...normal) || 1;
  return normal.map((part) => part / length) as Triangle;
}

export function hullVertices({ drawn, cornerStarts, triangleStarts, corners, triangles }: DrawnBlocks): HullVertices {
  const count = triangles.length;
  const numbers = () => new Float32Array(3 * count);
  const made = { corners: numbers(), normals: numbers(), owners: new Float32Array(count), sides: numbers() };
  for (let block = 0; block < drawn.length; ++block) {
    const own = corners.subarray(3 * cornerStarts[block]!, 3 * cornerStarts[block + 1]!);
    const [first, end] = [triangleStarts[block]!, triangleStarts[block + 1]!];
    const hull = Array.from({ length: end - first }, (_, k) => [...triangles.subarray(3 * (first + k), 3 * (first + k + 1))] as Triangle);
    const normals = hull.map((triangle) => normalOf(own, triangle));
    // The triangle with a side from one corner to another; its neighbour has the side from there back.
    const across = new Map<string, number>(hull.flatMap((triangle, k) => triangle.map((from, side) => [`${from} ${triangle[(side + 1) % 3]}`, k] as const)));
    hull.forEach((triangle, k) => {
      const normal = normals[k]!;
      // Side k is across from corner k.
      const isEdge = triangle.map((_, side) => {
        const neighbour = across.get(`${triangle[(side + 2) % 3]} ${triangle[(side + 1) % 3]}`);
        const other = neighbour === undefined ? null : normals[neighbour]!;
        return !other || normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2] < flat;
      });
      triangle.forEach((corner, of) => {
        const to = 3 * (first + k) + of;
        made.corners.set(own.subarray(3 * corner, 3 * corner + 3), 3 * to);
        made.normals.set(normal, 3 * to);
        made.owners[to] = block;
        made.sides.set(isEdge.map((is, side) => (is && side !== of ? 0 : 1)), 3 * to);
      });
    });
  }
  return made;
}
