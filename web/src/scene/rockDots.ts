// Rocks where they are at a moment.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, Points, ShaderMaterial } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import { RocksAtTime } from '../paths/rocksAtTime';
import { colourGlsl, tableGlsl, type PathLook } from './pathShader';

const vertex = /* glsl */ `
${colourGlsl}
in vec4 values;
uniform float size;
out float place;
void main() {
  vec4 rock = rockOf(values);
  place = placeOf(values, rock);
  vec4 at = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  at.z -= 0.002 * at.w;
  gl_Position = rock.w > 0.5 ? at : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = size;
}`;
const fragment = /* glsl */ `
precision highp float;
${tableGlsl}
uniform float size;
uniform vec3 rim;
in float place;
out vec4 colour;
void main() {
  float r = length(gl_PointCoord - 0.5) * size;
  float edge = 0.5 * size;
  if (r > edge) discard;
  colour = vec4(mix(colourFor(place), rim, smoothstep(0.55 * edge, 0.7 * edge, r)), 1.0 - smoothstep(edge - 1.0, edge, r));
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
    const size = (count > 2000 ? 6 : 9) * Math.min(devicePixelRatio, 2);
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: { ...look.uniforms, size: { value: size }, rim: { value: [0.08, 0.08, 0.1] } },
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
