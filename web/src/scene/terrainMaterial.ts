// The shader of the terrain: light from the north-west with ambient light, colours by elevation, slope or material,
// contours, and a draped map.

import { DataTexture, DoubleSide, GLSL3, LinearFilter, NearestFilter, RGBAFormat, ShaderMaterial, Vector2, Vector4, type Texture } from 'three';
import { colourOf, elevationRamp, groundColour, listBytes, materialColour, rampBytes, slopeRamp, type Colour } from '../view/colours';
import { mostDraped } from '../layers/draped';
import type { Shading } from '../view/settings';
import { lightGlsl } from './light';

/// A picture over the terrain, in the scene's coordinates.
export interface DrapedPicture {
  texture: Texture;
  corner: [number, number]; // in the south-west
  size: [number, number];
  opacity: number;
}

const vertex = /* glsl */ `
#ifdef TILE
in vec2 node;
in float height;
in vec2 gradient;
out vec2 cell;    // position in the tile, in cells
#else
in float ground;
flat out int kind;
#endif
out vec3 place;   // in the scene's coordinates, without exaggeration
out vec3 across;  // normal of the smooth surface
uniform float exaggeration;
void main() {
#ifdef TILE
  cell = node;
  vec3 at = vec3(node, height);
  across = vec3(-gradient, 1.0);
#else
  vec3 at = position;
  across = normal;
  kind = int(ground + 0.5);
#endif
  vec4 world = modelMatrix * vec4(at, 1.0);
  place = vec3(world.xy, world.z / exaggeration);
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

const fragment = /* glsl */ `
precision highp float;
in vec3 place;
in vec3 across;
#ifdef TILE
in vec2 cell;
uniform sampler2D cellKinds;
#else
flat in int kind;
#endif
out vec4 colour;
uniform float exaggeration;
uniform int shading;       // 0 hillshade, 1 elevation, 2 slope, 3 material
uniform bool faceted;
uniform vec2 range;        // minimum and maximum z
uniform sampler2D ramp;
uniform sampler2D kinds;
uniform int kindCount;
uniform vec3 plain;
uniform vec3 ink;
uniform float interval;    // of contours; 0: none
uniform float phase;       // the z of the frame's base, within five intervals
uniform sampler2D map;
uniform vec4 mapArea;      // its south-west corner and its size
uniform float mapOpacity;
uniform sampler2D pictures[MOST_DRAPED];
uniform vec4 pictureAreas[MOST_DRAPED];    // as mapArea
uniform float pictureOpacities[MOST_DRAPED];

${lightGlsl}

/// Draws a picture, whose colours are multiplied by their alpha, over a colour. Returns how much of it is covered.
float drape(sampler2D picture, vec4 area, float opacity, inout vec3 base) {
  vec2 at = (place.xy - area.xy) / area.zw;
  bool isInside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThanEqual(at, vec2(1.0)));
  vec4 value = texture(picture, at) * (isInside ? opacity : 0.0);
  base = base * (1.0 - value.a) + value.rgb;
  return value.a;
}

float lineAt(float value, float width) {
  float slope = fwidth(value);
  float off = abs(fract(value - 0.5) - 0.5) / max(slope, 1e-6);
  // Hidden where lines would merge, and where level ground would be one broad line.
  float isSeen = (1.0 - smoothstep(0.15, 0.45, slope)) * smoothstep(1e-5, 1e-4, slope);
  return (1.0 - smoothstep(width - 0.5, width + 0.5, off)) * isSeen;
}

void main() {
  vec3 n = faceted ? cross(dFdx(place), dFdy(place)) : across;
  n = normalize(n);
  if (n.z < 0.0) n = -n;
  float steepness = degrees(acos(clamp(n.z, 0.0, 1.0)));
  vec3 shown = normalize(vec3(n.xy, n.z / exaggeration));

  vec3 base = plain;
  if (shading == 1) base = texture(ramp, vec2((place.z - range.x) / max(range.y - range.x, 1e-6), 0.5)).rgb;
  if (shading == 2) base = texture(ramp, vec2(steepness / 70.0, 0.5)).rgb;
  if (shading == 3) {
#ifdef TILE
    ivec2 at = clamp(ivec2(cell), ivec2(0), textureSize(cellKinds, 0) - 1);
    int kind = int(255.0 * texelFetch(cellKinds, at, 0).r + 0.5);
#endif
    base = texelFetch(kinds, ivec2(kind % kindCount, 0), 0).rgb;
  }

  float light = lightOn(shown);
  vec3 tint = tintOn(shown);

  float covered = 0.0;
  // (An index of samplers must be constant.)
${[0, 1, 2, 3].map((k) => `  if (pictureOpacities[${k}] > 0.0) covered = max(covered, drape(pictures[${k}], pictureAreas[${k}], pictureOpacities[${k}], base));`).join('\n')}
  // A photograph has its own light and shade.
  light = mix(light, 0.75 + 0.25 * light, covered);
  tint = mix(tint, vec3(1.0), covered);

  if (mapOpacity > 0.0) {
    vec2 at = (place.xy - mapArea.xy) / mapArea.zw;
    if (all(greaterThanEqual(at, vec2(0.0))) && all(lessThanEqual(at, vec2(1.0)))) {
      vec4 value = texture(map, at);
      base = mix(base, value.rgb, value.a * mapOpacity);
      light = mix(light, 0.5 + 0.5 * light, value.a * mapOpacity);
    }
  }
  vec3 lit = base * light * tint;
  if (interval > 0.0) {
    float level = (place.z + phase) / interval;
    float line = max(0.28 * lineAt(level, 0.45), 0.5 * lineAt(level / 5.0, 0.7));
    lit = mix(lit, ink, line);
  }
  colour = vec4(lit, 1.0);
}`;

const dark: Colour = [28, 24, 18];
const unit = (colour: Colour) => colour.map((value) => value / 255);

function texture(bytes: Uint8Array<ArrayBuffer>, filter: typeof NearestFilter | typeof LinearFilter) {
  const made = new DataTexture(bytes, bytes.length / 4, 1, RGBAFormat);
  made.magFilter = made.minFilter = filter;
  made.needsUpdate = true;
  return made;
}

const modes: Record<Shading, number> = { hillshade: 0, elevation: 1, slope: 2, material: 3 };

function uniforms() {
  return {
    exaggeration: { value: 1 },
    shading: { value: 1 },
    faceted: { value: false },
    range: { value: new Vector2(0, 1) },
    ramp: { value: texture(rampBytes(elevationRamp.light), LinearFilter) },
    kinds: { value: texture(listBytes([materialColour(0)]), NearestFilter) },
    kindCount: { value: 1 },
    cellKinds: { value: null as DataTexture | null }, // of the current tile
    plain: { value: unit(groundColour.light) },
    ink: { value: unit(dark) },
    interval: { value: 0 },
    phase: { value: 0 },
    map: { value: null as DataTexture | null },
    mapArea: { value: new Vector4(0, 0, 1, 1) },
    mapOpacity: { value: 0 },
    pictures: { value: Array.from({ length: mostDraped }, () => null as Texture | null) },
    pictureAreas: { value: Array.from({ length: mostDraped }, () => new Vector4(0, 0, 1, 1)) },
    pictureOpacities: { value: Array.from({ length: mostDraped }, () => 0) },
  };
}
export type TerrainUniforms = ReturnType<typeof uniforms>;

export class TerrainMaterial extends ShaderMaterial {
  declare uniforms: TerrainUniforms;

  constructor(tiles: boolean) {
    super({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: uniforms(),
      defines: { MOST_DRAPED: mostDraped, ...(tiles && { TILE: 1 }) },
      side: DoubleSide,
      // Keeps lines on the ground visible.
      polygonOffset: true,
      polygonOffsetFactor: 1.5,
      polygonOffsetUnits: 4,
    });
  }

  paint(shading: Shading, shade: 'light' | 'dark', materials: number) {
    const { ramp, kinds } = this.uniforms;
    ramp.value.dispose();
    ramp.value = texture(rampBytes((shading === 'slope' ? slopeRamp : elevationRamp)[shade]), LinearFilter);
    kinds.value.dispose();
    kinds.value = texture(listBytes(Array.from({ length: Math.max(1, materials) }, (_, k) => materialColour(k))), NearestFilter);
    this.uniforms.kindCount.value = Math.max(1, materials);
    this.uniforms.shading.value = modes[shading];
    this.uniforms.plain.value = unit(groundColour[shade]);
    this.uniforms.ink.value = unit(shade === 'light' ? dark : colourOf('#101010'));
  }

  /// The lowest first, at most `mostDraped`.
  drape(list: readonly DrapedPicture[]) {
    const { pictures, pictureAreas, pictureOpacities } = this.uniforms;
    for (let k = 0; k < mostDraped; ++k) {
      const shown = list[k];
      pictures.value[k] = shown?.texture ?? null;
      pictureOpacities.value[k] = shown?.opacity ?? 0;
      if (shown) pictureAreas.value[k]!.set(...shown.corner, ...shown.size);
    }
  }

  override dispose() {
    this.uniforms.ramp.value.dispose();
    this.uniforms.kinds.value.dispose();
    super.dispose();
  }
}
