// The rocks at a time.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, Points, ShaderMaterial } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import { leastRadius, leastShare } from '../paths/rockSize';
import { RocksAtTime } from '../paths/rocksAtTime';
import { colourOf, restColour } from '../view/colours';
import { colourGlsl, tableGlsl, type PathLook } from './pathShader';

/// The colour of rocks at rest, for shaders.
export const restUnit = colourOf(restColour).map((part) => part / 255);

/// The drawn size of a rock.
export const sizeGlsl = /* glsl */ `
uniform float largest; // maximum radius, m
uniform float least;   // minimum drawn radius of the largest rock, CSS pixels
uniform vec2 pixels;   // size of the picture, CSS pixels
float pixelsPerMetreAt(vec4 clip) { return projectionMatrix[1][1] * 0.5 * pixels.y / clip.w; }
/// The minimum drawn radius, CSS pixels.
float leastRadiusOf(float radius) {
  float share = largest > 0.0 ? radius / largest : 1.0;
  return least * (${leastShare} + (1.0 - ${leastShare}) * share);
}
/// A smaller rock with a shape is a dot.
bool isDrawnAsBlock(float radius, vec4 clip) { return clip.w > 0.0 && radius * pixelsPerMetreAt(clip) > leastRadiusOf(radius); }`;

/// The uniforms of sizeGlsl that differ between runs.
export function sizeUniforms({ radii }: DrawnPaths) {
  return {
    largest: { value: radii.reduce((most, radius) => Math.max(most, radius), 0) },
    least: { value: leastRadius(radii.length) },
  };
}

const vertex = /* glsl */ `
${colourGlsl}
${sizeGlsl}
in vec4 values;
in float radius;       // m
in float isBlock;      // 1: it is also a block of blockMesh.ts
uniform float ratio;   // drawing buffer pixels per CSS pixel
uniform bool isWhole;  // all rocks have stopped
out float place;
out float diameter;
out float atRest;
void main() {
  vec4 rock = rockOf(values);
  place = placeOf(values, rock);
  // Rocks at rest have no speed, energy or height to colour by.
  atRest = isWhole && quantity < 3 ? 1.0 : 0.0;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  vec4 at = projectionMatrix * eye;
  float pixelsPerMetre = pixelsPerMetreAt(at);
  float seen = radius * pixelsPerMetre;
  diameter = 2.0 * ratio * max(seen, leastRadiusOf(radius));
  // Moved towards the camera, so that the ground in front does not cut its lower half.
  vec4 front = projectionMatrix * (eye + vec4(0.0, 0.0, diameter / ratio / pixelsPerMetre, 0.0));
  if (front.w > 0.0) at.z = front.z / front.w * at.w;
  bool isSeen = rock.w > 0.5 && !(isBlock > 0.5 && isDrawnAsBlock(radius, at));
  gl_Position = isSeen ? at : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = diameter + 2.0 * ratio;
}`;
const fragment = /* glsl */ `
precision highp float;
${tableGlsl}
uniform vec3 rest;
uniform float ratio;
in float place;
in float diameter;
in float atRest;
out vec4 colour;
void main() {
  float size = diameter + 2.0 * ratio;
  vec2 off = (gl_PointCoord - 0.5) * size;
  float r = length(off);
  float edge = 0.5 * diameter;
  if (r > edge + ratio) discard;
  vec3 fill = atRest > 0.5 ? rest : colourFor(place);
  // An outline that contrasts with the colour, and light from the upper left.
  vec3 rim = dot(fill, vec3(0.2126, 0.7152, 0.0722)) < 0.43 ? vec3(1.0) : vec3(0.165, 0.149, 0.125);
  float wide = min(0.9 * ratio, 0.28 * edge);
  vec2 n = off / edge;
  float light = 1.0 - 0.28 * smoothstep(0.2, 1.0, dot(n, n)) + 0.14 * dot(n, vec2(-0.7, -0.7));
  vec3 body = fill * min(light, 1.15);
  colour = vec4(mix(body, rim, smoothstep(edge - wide, edge - 0.2 * wide, r)), 1.0 - smoothstep(edge, edge + 0.8 * ratio, r));
}`;

export class RockDots {
  readonly object: Points;
  private readonly rocks: RocksAtTime;
  private readonly read: Float32Array;

  constructor(
    private readonly paths: DrawnPaths,
    look: PathLook,
    private readonly shift: ArrayLike<number>,
  ) {
    this.rocks = new RocksAtTime(paths);
    const count = paths.rocks.length;
    this.read = new Float32Array(count);
    const values = new Float32Array(4 * count);
    for (let k = 0; k < count; ++k) values[4 * k + 3] = k;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute('values', new BufferAttribute(values, 4).setUsage(DynamicDrawUsage));
    geometry.setAttribute('radius', new BufferAttribute(paths.radii.slice(), 1));
    geometry.setAttribute('isBlock', new BufferAttribute(new Float32Array(count), 1));
    const own = {
      ...sizeUniforms(paths),
      rest: { value: restUnit },
    };
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: { ...look.uniforms, ...own },
      transparent: true,
      depthWrite: false,
    });
    this.object = new Points(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 10;
  }

  /// Leaves out large dots of these rocks, by their index: they are drawn as blocks.
  leaveToBlocks(drawn: ArrayLike<number>) {
    const flags = this.object.geometry.getAttribute('isBlock');
    flags.array.fill(0);
    for (let k = 0; k < drawn.length; ++k) flags.array[drawn[k]!] = 1;
    flags.needsUpdate = true;
  }

  /// Of each drawn rock at the last time: speed, energy, height, and its index.
  get values(): ArrayLike<number> {
    return this.object.geometry.getAttribute('values').array;
  }

  at(time: number) {
    const { geometry } = this.object;
    const [position, values] = [geometry.getAttribute('position'), geometry.getAttribute('values')];
    this.rocks.find(time);
    this.rocks.read(this.paths.positions, 3, position.array as Float32Array, this.shift);
    [this.paths.speeds, this.paths.energies, this.paths.heights].forEach((quantity, axis) => {
      this.rocks.read(quantity, 1, this.read);
      for (let k = 0; k < this.read.length; ++k) values.array[4 * k + axis] = this.read[k]!;
    });
    position.needsUpdate = values.needsUpdate = true;
  }
}
