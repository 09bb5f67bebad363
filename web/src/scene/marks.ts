// Marks on the terrain: seeders, barriers, drawings of tools.

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
  Vector2,
  type Object3D,
  type Vector3,
} from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { meanSpacing } from '../paths/rockSize';

interface Look {
  colour: string;
  /// In pixels.
  size: number;
  /// Whether it is visible through the terrain.
  above?: boolean;
  shape?: 'disc' | 'diamond' | 'cross';
}

const shapes = { disc: 0, diamond: 1, cross: 2 };

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
uniform float size;     // maximum diameter, CSS pixels
uniform float spacing;  // between neighbours, m
uniform vec2 pixels;    // size of the drawing buffer
uniform float ratio;    // drawing buffer pixels per CSS pixel
out float diameter;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * eye;
  float pixelsPerMetre = projectionMatrix[1][1] * 0.5 * pixels.y / gl_Position.w;
  diameter = clamp(0.72 * spacing * pixelsPerMetre, 2.0 * ratio, size * ratio);
  // Moved towards the camera, so that the ground in front does not cut it.
  vec4 front = projectionMatrix * (eye + vec4(0.0, 0.0, diameter / pixelsPerMetre, 0.0));
  if (front.w > 0.0) gl_Position.z = front.z / front.w * gl_Position.w;
  gl_PointSize = diameter;
}`;
const dotFragment = /* glsl */ `
precision highp float;
uniform vec3 colour;
uniform float ratio;
uniform int shape;  // 0: disc, 1: diamond, 2: diagonal cross
in float diameter;
out vec4 result;
void main() {
  vec2 off = abs(gl_PointCoord - 0.5) * diameter;
  float r = shape == 1 ? off.x + off.y : length(off);
  if (shape == 2) {
    float across = abs(off.x - off.y) * 0.70711;
    float arm = 0.11 * diameter;
    if (across > arm + 1.2 * ratio) discard;
    result = vec4(mix(colour, vec3(1.0), smoothstep(arm - 0.2 * ratio, arm + 0.2 * ratio, across)), 1.0);
    return;
  }
  float edge = 0.5 * diameter;
  if (r > edge) discard;
  float wide = diameter >= 6.0 * ratio ? 1.6 * ratio : 0.0;
  float rim = wide > 0.0 ? smoothstep(edge - wide - ratio, edge - wide, r) : 0.0;
  result = vec4(mix(colour, vec3(1.0), rim), 1.0 - smoothstep(edge - ratio, edge, r));
}`;

const numbersOf = (points: readonly Vector3[] | Float32Array) =>
  points instanceof Float32Array ? points : new Float32Array(points.flatMap((point) => point.toArray()));

/// Discs with a white rim, small enough not to overlap.
export function dots(points: readonly Vector3[] | Float32Array, { colour, size, above, shape = 'disc' }: Look): Object3D {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(numbersOf(points), 3));
  const { r, g, b } = new Color(colour).convertLinearToSRGB();
  const spacing = above || points instanceof Float32Array ? Infinity : meanSpacing(points.map(({ x, y }) => [x, y]));
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: dotVertex,
    fragmentShader: dotFragment,
    uniforms: {
      size: { value: size },
      spacing: { value: Math.min(spacing, 1e9) },
      colour: { value: [r, g, b] },
      shape: { value: shapes[shape] },
      pixels: { value: new Vector2() },
      ratio: { value: 1 },
    },
    transparent: true,
    depthTest: !above,
    depthWrite: false,
  });
  const made = new Points(geometry, material);
  made.onBeforeRender = (renderer) => {
    renderer.getDrawingBufferSize(material.uniforms.pixels!.value as Vector2);
    material.uniforms.ratio!.value = renderer.getPixelRatio();
  };
  made.renderOrder = above ? 21 : 6;
  made.frustumCulled = false;
  return made;
}

/// Separate line segments, two points each, drawn in one call.
export function pieces(points: readonly Vector3[] | Float32Array, { colour, size }: Look, opacity = 1): Object3D {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(numbersOf(points));
  const material = new LineMaterial({ color: new Color(colour), linewidth: size, transparent: true, opacity });
  const made = new LineSegments2(geometry, material);
  made.renderOrder = 5;
  made.frustumCulled = false;
  return made;
}

/// A wall between two lines with the same number of points.
export interface Wall {
  foot: Vector3[];
  top: Vector3[];
}

const along = (points: Vector3[]) => points.slice(1).flatMap((point, k) => [points[k]!, point]);

/// Walls of one colour: three objects for any number of walls of any length.
export function walls(list: readonly Wall[], colour: string): Object3D {
  const group = new Group();
  const positions: Vector3[] = [];
  const index: number[] = [];
  for (const { foot, top } of list) {
    const [first, count] = [positions.length, Math.min(foot.length, top.length)];
    positions.push(...foot.slice(0, count), ...top.slice(0, count));
    for (let k = first; k + 1 < first + count; ++k) index.push(k, k + 1, count + k + 1, k, count + k + 1, count + k);
  }
  if (index.length === 0) return group;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions.flatMap((point) => point.toArray())), 3));
  geometry.setIndex(index);
  const material = new MeshBasicMaterial({ color: colour, side: DoubleSide, transparent: true, opacity: 0.45, depthWrite: false });
  const faces = new Mesh(geometry, material);
  faces.renderOrder = 4;
  const posts = list.flatMap(({ foot, top }) => foot.slice(0, top.length).flatMap((point, k) => [point, top[k]!]));
  group.add(
    faces,
    pieces(list.flatMap(({ top }) => along(top)), { colour, size: 2.5 }),
    pieces([...list.flatMap(({ foot }) => along(foot)), ...posts], { colour, size: 1.5 }),
  );
  return group;
}

/// A fan of triangles in a convex outline.
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
