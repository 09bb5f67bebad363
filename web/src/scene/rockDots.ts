// The rocks at a time.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, Points, ShaderMaterial } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import { leastRadius, leastShare } from '../paths/rockSize';
import { RocksAtTime } from '../paths/rocksAtTime';
import { colourOf, restColour } from '../view/colours';
import { colourGlsl, tableGlsl, type PathLook } from './pathShader';

const vertex = /* glsl */ `
${colourGlsl}
in vec4 values;
in float radius;       // m
uniform float largest; // maximum radius, m
uniform float least;   // minimum drawn radius of the largest rock, CSS pixels
uniform vec2 pixels;   // size of the picture, CSS pixels
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
  float pixelsPerMetre = projectionMatrix[1][1] * 0.5 * pixels.y / at.w;
  float seen = radius * pixelsPerMetre;
  float share = largest > 0.0 ? radius / largest : 1.0;
  diameter = 2.0 * ratio * max(seen, least * (${leastShare} + (1.0 - ${leastShare}) * share));
  // Moved towards the camera, so that the ground in front does not cut its lower half.
  vec4 front = projectionMatrix * (eye + vec4(0.0, 0.0, diameter / ratio / pixelsPerMetre, 0.0));
  if (front.w > 0.0) at.z = front.z / front.w * at.w;
  gl_Position = rock.w > 0.5 ? at : vec4(2.0, 2.0, 2.0, 1.0);
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
    const largest = paths.radii.reduce((most, radius) => Math.max(most, radius), 0);
    const own = {
      largest: { value: largest },
      least: { value: leastRadius(count) },
      rest: { value: colourOf(restColour).map((part) => part / 255) },
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
