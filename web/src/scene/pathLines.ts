// All trajectories of a run in one buffer: drawn as ribbons several pixels wide, or as thin lines if there are very many.

import {
  GLSL3,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  BufferAttribute,
  BufferGeometry,
  Line,
  Mesh,
  ShaderMaterial,
  type Object3D,
} from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import { colourGlsl, tableGlsl, type PathLook } from './pathShader';

const mostRibbons = 400_000; // segments; a ribbon costs four times as much as a line
const restart = 0xffffffff; // the index that starts a new line in WebGL 2

const vertex = /* glsl */ `
${colourGlsl}
in vec4 here;        // a point and its time
in vec4 hereValues;
#ifdef RIBBON
in vec4 next;
in vec4 nextValues;
uniform vec2 pixels;   // size of the picture, CSS pixels
uniform float width;   // CSS pixels
#endif
uniform float time;
out float place;
out float moment;
void main() {
  vec4 rock = rockOf(hereValues);
  vec4 at = projectionMatrix * modelViewMatrix * vec4(here.xyz, 1.0);
  vec4 values = hereValues;
  moment = here.w;
  bool isShown = rock.w > 0.5;
#ifdef RIBBON
  vec4 to = projectionMatrix * modelViewMatrix * vec4(next.xyz, 1.0);
  isShown = isShown && hereValues.w == nextValues.w && here.w <= time && at.w > 0.0 && to.w > 0.0;
  vec2 along = (to.xy / to.w - at.xy / at.w) * pixels;
  float size = length(along);
  vec2 across = size > 1e-4 ? vec2(-along.y, along.x) / size : vec2(1.0, 0.0);
  vec2 step = size > 1e-4 ? along / size : vec2(0.0);
  bool isEnd = gl_VertexID > 1;
  if (isEnd) {
    at = to;
    values = nextValues;
    moment = next.w;
  }
  float side = (gl_VertexID & 1) == 0 ? 1.0 : -1.0;
  // Slightly longer than the segment, so that bends have no gaps.
  at.xy += (side * across + (isEnd ? 0.35 : -0.35) * step) * width / pixels * at.w;
#endif
  place = placeOf(values, rock);
  at.z -= 0.0006 * at.w;
  gl_Position = isShown ? at : vec4(2.0, 2.0, 2.0, 1.0);
}`;

const fragment = /* glsl */ `
precision highp float;
${tableGlsl}
uniform float time;
uniform float opacity;
in float place;
in float moment;
out vec4 colour;
void main() {
  if (moment > time) discard;
  colour = vec4(colourFor(place), opacity);
}`;

/// Eight numbers per point: x, y, z, time, speed, energy, height, rock.
function interleaved({ starts, positions, times, speeds, energies, heights }: DrawnPaths, shift: ArrayLike<number>) {
  const all = new Float32Array(8 * times.length);
  for (let rock = 0; rock + 1 < starts.length; ++rock)
    for (let k = starts[rock]!; k < starts[rock + 1]!; ++k) {
      all[8 * k] = positions[3 * k]! + shift[0]!;
      all[8 * k + 1] = positions[3 * k + 1]! + shift[1]!;
      all[8 * k + 2] = positions[3 * k + 2]! + shift[2]!;
      all[8 * k + 3] = times[k]!;
      all[8 * k + 4] = speeds[k]!;
      all[8 * k + 5] = energies[k]!;
      all[8 * k + 6] = heights[k]!;
      all[8 * k + 7] = rock;
    }
  return all;
}

function ribbons(points: Float32Array): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const buffer = new InstancedInterleavedBuffer(points, 8, 1);
  geometry.setAttribute('here', new InterleavedBufferAttribute(buffer, 4, 0));
  geometry.setAttribute('hereValues', new InterleavedBufferAttribute(buffer, 4, 4));
  geometry.setAttribute('next', new InterleavedBufferAttribute(buffer, 4, 8));
  geometry.setAttribute('nextValues', new InterleavedBufferAttribute(buffer, 4, 12));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.instanceCount = points.length / 8 - 1;
  return geometry;
}

function thinLines(points: Float32Array, starts: Uint32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  const buffer = new InterleavedBuffer(points, 8);
  geometry.setAttribute('here', new InterleavedBufferAttribute(buffer, 4, 0));
  geometry.setAttribute('hereValues', new InterleavedBufferAttribute(buffer, 4, 4));
  const index = new Uint32Array(points.length / 8 + starts.length - 1);
  let at = 0;
  for (let rock = 0; rock + 1 < starts.length; ++rock) {
    for (let k = starts[rock]!; k < starts[rock + 1]!; ++k) index[at++] = k;
    index[at++] = restart;
  }
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

/// `shift` converts positions to the scene's coordinates.
export function pathLines(paths: DrawnPaths, look: PathLook, shift: ArrayLike<number>): Object3D {
  const points = interleaved(paths, shift);
  const areRibbons = paths.times.length <= mostRibbons;
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: vertex,
    fragmentShader: fragment,
    uniforms: look.uniforms,
    defines: areRibbons ? { RIBBON: 1 } : {},
    transparent: true,
    depthWrite: false,
  });
  material.side = 2; // DoubleSide
  const made = areRibbons ? new Mesh(ribbons(points), material) : new Line(thinLines(points, paths.starts), material);
  made.frustumCulled = false;
  made.renderOrder = 8;
  return made;
}
