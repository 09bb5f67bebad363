// Lines, points and bands that mark things on the terrain: seeders, barriers, what tools draw.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  GLSL3,
  Group,
  Mesh,
  MeshBasicMaterial,
  Points,
  ShaderMaterial,
  type Object3D,
  type Vector3,
} from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';

interface Look {
  colour: string;
  /// Pixels.
  size: number;
  /// Seen through the terrain.
  above?: boolean;
}

export function line(points: Vector3[], { colour, size, above }: Look, closed = false): Object3D {
  if (points.length < 2) return new Group();
  const geometry = new LineGeometry();
  const all = closed ? [...points, points[0]!] : points;
  geometry.setPositions(all.flatMap((point) => point.toArray()));
  const material = new LineMaterial({ color: new Color(colour), linewidth: size, depthTest: !above, transparent: true });
  const made = new Line2(geometry, material);
  made.renderOrder = above ? 20 : 5;
  made.frustumCulled = false;
  return made;
}

const dotVertex = /* glsl */ `
uniform float size;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.002 * gl_Position.w;
  gl_PointSize = size;
}`;
const dotFragment = /* glsl */ `
precision highp float;
uniform vec3 colour;
uniform float size;
uniform float rimmed;
out vec4 result;
void main() {
  float r = length(gl_PointCoord - 0.5) * size;
  float edge = 0.5 * size;
  if (r > edge) discard;
  float rim = rimmed * smoothstep(edge - 2.5, edge - 1.5, r);
  result = vec4(mix(colour, vec3(1.0), rim), 1.0 - smoothstep(edge - 1.0, edge, r));
}`;

/// Discs, with a white rim unless they are small.
export function dots(points: Vector3[], { colour, size, above }: Look): Object3D {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(points.flatMap((point) => point.toArray())), 3));
  const { r, g, b } = new Color(colour).convertLinearToSRGB();
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: dotVertex,
    fragmentShader: dotFragment,
    uniforms: { size: { value: size * Math.min(devicePixelRatio, 2) }, colour: { value: [r, g, b] }, rimmed: { value: size < 8 ? 0 : 1 } },
    transparent: true,
    depthTest: !above,
    depthWrite: false,
  });
  const made = new Points(geometry, material);
  made.renderOrder = above ? 21 : 6;
  made.frustumCulled = false;
  return made;
}

/// A wall between two lines of as many points.
export function band(foot: Vector3[], top: Vector3[], colour: string): Object3D {
  const count = Math.min(foot.length, top.length);
  const geometry = new BufferGeometry();
  const positions = [...foot.slice(0, count), ...top.slice(0, count)].flatMap((point) => point.toArray());
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  const index: number[] = [];
  for (let k = 0; k + 1 < count; ++k) index.push(k, k + 1, count + k + 1, k, count + k + 1, count + k);
  geometry.setIndex(index);
  const material = new MeshBasicMaterial({ color: colour, side: DoubleSide, transparent: true, opacity: 0.45, depthWrite: false });
  const wall = new Mesh(geometry, material);
  wall.renderOrder = 4;
  const group = new Group();
  group.add(wall, line(top, { colour, size: 2.5 }), line(foot, { colour, size: 1.5 }));
  for (let k = 0; k < count; ++k) group.add(line([foot[k]!, top[k]!], { colour, size: 1.5 }));
  return group;
}

/// A fan over a closed line; for convex outlines such as a triangle.
export function patch(points: Vector3[], colour: string): Object3D {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(points.flatMap((point) => point.toArray())), 3));
  geometry.setIndex(Array.from({ length: Math.max(0, points.length - 2) }, (_, k) => [0, k + 1, k + 2]).flat());
  const material = new MeshBasicMaterial({ color: colour, side: DoubleSide, transparent: true, opacity: 0.35, depthTest: false });
  const made = new Mesh(geometry, material);
  made.renderOrder = 19;
  return made;
}

export function clear(group: Group) {
  group.traverse((object) => {
    const { geometry, material } = object as Mesh;
    geometry?.dispose();
    if (Array.isArray(material)) material.forEach((each) => each.dispose());
    else material?.dispose();
  });
  group.clear();
}
