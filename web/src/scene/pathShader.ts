// Colours of trajectories and rocks: quantities are vertex attributes, categories of rocks are in a texture, colours in a
// table. Changing the colouring only changes uniforms.

import { DataTexture, LinearFilter, NearestFilter, RGBAFormat, RGBAIntegerFormat, UnsignedShortType } from 'three';
import type { Colouring } from '../paths/colouring';
import type { DrawnPaths } from '../paths/drawnPaths';
import { colourOf, listBytes, rampBytes } from '../view/colours';

/// How much nearer than they are lines and blocks are drawn, so that the ground does not cut them; of the depth.
export const nearer = 0.0006;

const rocksAcross = 1024; // texels in a row of the rocks' texture

/// `values`: speed, energy, height, and the rock's index among the drawn ones.
export const colourGlsl = /* glsl */ `
uniform highp usampler2D rocks;  // for each rock: source, seeder, reason, whether it passes the filter
uniform sampler2D table;
uniform int quantity;            // 0 speed, 1 energy, 2 height, 3 source, 4 seeder, 5 reason, 6 one colour
uniform float low;
uniform float high;
uniform int kindCount;
uniform vec3 single;
vec4 rockOf(vec4 values) {
  int rock = int(values.w + 0.5);
  return vec4(texelFetch(rocks, ivec2(rock % ${rocksAcross}, rock / ${rocksAcross}), 0));
}
/// Position on the scale or index of the category; negative: unknown.
float placeOf(vec4 values, vec4 rock) {
  if (quantity > 5) return 0.0;
  if (quantity > 2) return float((int(rock[quantity - 3] + 0.5)) % kindCount);
  float value = values[quantity];
  return isnan(value) ? -1.0 : clamp((value - low) / max(high - low, 1e-9), 0.0, 1.0);
}`;
export const tableGlsl = /* glsl */ `
uniform sampler2D table;
uniform int quantity;
uniform vec3 single;
vec3 colourFor(float place) {
  if (quantity > 5) return single;
  if (quantity > 2) return texelFetch(table, ivec2(int(place + 0.5), 0), 0).rgb;
  return place < 0.0 ? vec3(0.55) : texture(table, vec2((0.5 + 255.0 * place) / 256.0, 0.5)).rgb;
}`;

const quantities = ['speed', 'energy', 'height', 'source', 'seeder', 'reason'];

function rockTexture({ sources, seeders, reasons }: DrawnPaths): DataTexture {
  const rows = Math.max(1, Math.ceil(sources.length / rocksAcross));
  const texels = new Uint16Array(4 * rocksAcross * rows);
  for (let k = 0; k < sources.length; ++k) texels.set([sources[k]!, seeders[k]!, reasons[k]!, 1], 4 * k);
  const made = new DataTexture(texels, rocksAcross, rows, RGBAIntegerFormat, UnsignedShortType);
  made.internalFormat = 'RGBA16UI';
  made.magFilter = made.minFilter = NearestFilter;
  made.needsUpdate = true;
  return made;
}

function tableTexture(bytes: Uint8Array<ArrayBuffer>): DataTexture {
  const made = new DataTexture(bytes, bytes.length / 4, 1, RGBAFormat);
  made.magFilter = made.minFilter = LinearFilter;
  made.needsUpdate = true;
  return made;
}

/// The uniforms shared by the lines and rocks of a run.
export class PathLook {
  readonly uniforms;

  constructor(paths: DrawnPaths) {
    this.uniforms = {
      rocks: { value: rockTexture(paths) },
      table: { value: tableTexture(new Uint8Array(4)) },
      quantity: { value: 6 },
      low: { value: 0 },
      high: { value: 1 },
      kindCount: { value: 1 },
      single: { value: [0, 0, 0] },
      time: { value: Infinity },
      pixels: { value: [1, 1] },
      ratio: { value: 1 },
      isWhole: { value: false },
      width: { value: 1 },
      opacity: { value: 1 },
    };
  }

  colourBy(how: Colouring) {
    if (how.kind === 'run') return this.colourAll(how.colour);
    const { uniforms } = this;
    uniforms.table.value.dispose();
    uniforms.quantity.value = quantities.indexOf(how.by);
    if (how.kind === 'scale') {
      uniforms.table.value = tableTexture(rampBytes(how.ramp));
      [uniforms.low.value, uniforms.high.value] = [how.low, how.high];
    } else {
      uniforms.table.value = tableTexture(listBytes(how.colours.length > 0 ? how.colours : ['#000000']));
      uniforms.kindCount.value = Math.max(1, how.colours.length);
    }
  }

  colourAll(colour: string) {
    this.uniforms.quantity.value = 6;
    this.uniforms.single.value = colourOf(colour).map((part) => part / 255);
  }

  /// Applies the filter; null: all pass.
  pass(passes: Uint8Array | null) {
    const { value: texture } = this.uniforms.rocks;
    const texels = texture.image.data as unknown as Uint16Array;
    for (let k = 0; 4 * k < texels.length; ++k) texels[4 * k + 3] = passes ? (passes[k] ?? 0) : 1;
    texture.needsUpdate = true;
  }

  dispose() {
    this.uniforms.rocks.value.dispose();
    this.uniforms.table.value.dispose();
  }
}

