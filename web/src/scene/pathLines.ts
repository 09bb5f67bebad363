// The trajectories of a run as ribbons several pixels wide, in one call, with as much detail as a picture can show.

import { Box3, BufferAttribute, BufferGeometry, DataTexture, FloatType, GLSL3, Mesh, NearestFilter, RGBAFormat, RGIntegerFormat, ShaderMaterial, UnsignedIntType, Vector3, type Texture } from 'three';
import type { DrawnPaths } from '../paths/drawnPaths';
import { fairOrder, neededUpTo, opacityOfShare, segmentsOf } from '../paths/pathDetail';
import { colourGlsl, nearer, tableGlsl, type PathLook } from './pathShader';

const across = 2048; // texels in a row

const vertex = /* glsl */ `
${colourGlsl}
uniform highp sampler2D points;     // of each point two texels: x, y, z, time; speed, energy, height, rock
uniform highp usampler2D segments;  // the first and the last point of each
uniform vec2 pixels;   // size of the picture, CSS pixels
uniform float width;   // CSS pixels
uniform float time;
out float place;
out float moment;
vec4 texelOf(uint number) {
  return texelFetch(points, ivec2(number % ${across}u, number / ${across}u), 0);
}
void main() {
  // Four vertices of each segment. An instance for each would take software forty times as long.
  int segment = gl_VertexID >> 2;
  uvec2 ends = texelFetch(segments, ivec2(segment % ${across}, segment / ${across}), 0).xy;
  vec4 here = texelOf(2u * ends.x), hereValues = texelOf(2u * ends.x + 1u);
  vec4 next = texelOf(2u * ends.y), nextValues = texelOf(2u * ends.y + 1u);
  vec4 rock = rockOf(hereValues);
  vec4 at = projectionMatrix * modelViewMatrix * vec4(here.xyz, 1.0);
  vec4 values = hereValues;
  moment = here.w;
  vec4 to = projectionMatrix * modelViewMatrix * vec4(next.xyz, 1.0);
  bool isShown = rock.w > 0.5 && here.w <= time && at.w > 0.0 && to.w > 0.0;
  vec2 along = (to.xy / to.w - at.xy / at.w) * pixels;
  float size = length(along);
  vec2 across = size > 1e-4 ? vec2(-along.y, along.x) / size : vec2(1.0, 0.0);
  vec2 step = size > 1e-4 ? along / size : vec2(0.0);
  bool isEnd = (gl_VertexID & 2) != 0;
  if (isEnd) {
    at = to;
    values = nextValues;
    moment = next.w;
  }
  float side = (gl_VertexID & 1) == 0 ? 1.0 : -1.0;
  // Slightly longer than the segment, so that bends have no gaps.
  at.xy += (side * across + (isEnd ? 0.35 : -0.35) * step) * width / pixels * at.w;
  place = placeOf(values, rock);
  at.z -= ${nearer} * at.w;
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

const rowsFor = (texels: number) => Math.max(1, Math.ceil(texels / across));

function textureOf(texture: DataTexture): DataTexture {
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/// `shift` converts positions to the scene's coordinates.
function pointTexture({ starts, positions, times, speeds, energies, heights }: DrawnPaths, shift: ArrayLike<number>): DataTexture {
  const rows = rowsFor(2 * times.length);
  const all = new Float32Array(4 * across * rows);
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
  return textureOf(new DataTexture(all, across, rows, RGBAFormat, FloatType));
}

function segmentTexture(ends: Uint32Array): DataTexture {
  const rows = rowsFor(ends.length / 2);
  const all = new Uint32Array(2 * across * rows);
  all.set(ends);
  const made = new DataTexture(all, across, rows, RGIntegerFormat, UnsignedIntType);
  made.internalFormat = 'RG32UI';
  return textureOf(made);
}

/// The triangles of ribbons, of as many segments as were ever wanted.
let corners = new BufferAttribute(new Uint32Array(0), 1);
function cornersOf(segments: number): BufferAttribute {
  if (corners.count < 6 * segments) {
    const count = Math.max(4096, 2 ** Math.ceil(Math.log2(segments)));
    const index = new Uint32Array(6 * count);
    for (let k = 0; k < count; ++k) {
      index[6 * k] = 4 * k;
      index[6 * k + 1] = 4 * k + 1;
      index[6 * k + 2] = index[6 * k + 3] = 4 * k + 2;
      index[6 * k + 4] = 4 * k + 1;
      index[6 * k + 5] = 4 * k + 3;
    }
    corners = new BufferAttribute(index, 1);
  }
  return corners;
}

/// One level of detail.
interface Level {
  segments: DataTexture;
  count: number;
  share: number;
  tolerance: number;
  most: number;
}

const finest = 0.05; // m; the tolerance of the points themselves
const coarsest = 1000; // m
/// The largest power of two times `finest` that is not above a tolerance, so that a level serves many views; 0: all points.
const levelBelow = (tolerance: number) => (tolerance < finest ? 0 : finest * 2 ** Math.floor(Math.log2(tolerance / finest)));

export class PathLines {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly needed: Float32Array;
  private readonly order: Uint32Array;
  private readonly box = new Box3();
  private readonly points: Texture;
  private readonly segments: { value: Texture | null } = { value: null };
  /// At rest and while the view moves.
  private readonly levels: [Level | null, Level | null] = [null, null];
  private passes: Uint8Array | null = null;
  private readonly opacity: number;

  constructor(
    private readonly paths: DrawnPaths,
    private readonly look: PathLook,
    shift: ArrayLike<number>,
  ) {
    this.needed = neededUpTo(paths);
    this.order = fairOrder(paths.rocks.length);
    this.box.setFromArray(paths.positions).translate(new Vector3().fromArray(shift));
    this.points = pointTexture(paths, shift);
    this.opacity = look.uniforms.opacity.value;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: { ...look.uniforms, points: { value: this.points }, segments: this.segments },
      transparent: true,
      depthWrite: false,
    });
    material.side = 2; // DoubleSide
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 8;
  }

  /// Null: all rocks.
  pass(passes: Uint8Array | null) {
    this.passes = passes;
    this.forget();
  }

  /// Chooses what is drawn. `eye`: in the scene's coordinates without exaggeration; `perMetre`: pixels of a metre at a
  /// distance of one metre; `tolerance` in pixels.
  choose(isMoving: boolean, eye: Vector3, perMetre: number, tolerance: number, most: number) {
    const which = isMoving ? 1 : 0;
    const wanted = levelBelow((tolerance * this.box.distanceToPoint(eye)) / perMetre);
    let level = this.levels[which];
    if (!level || level.tolerance !== wanted || level.most !== most) {
      level?.segments.dispose();
      level = this.levels[which] = this.levelOf(wanted, most, isMoving);
    }
    const { geometry } = this.object;
    this.segments.value = level.segments;
    geometry.setIndex(cornersOf(level.count));
    geometry.setDrawRange(0, 6 * level.count);
    this.look.uniforms.opacity.value = opacityOfShare(this.opacity, level.share);
  }

  private levelOf(tolerance: number, most: number, isMoving: boolean): Level {
    const { paths, needed, order, passes } = this;
    let used = tolerance;
    let { ends, share } = segmentsOf(paths, needed, order, passes, used, most);
    // At rest all rocks are drawn, with fewer points if there are very many.
    while (!isMoving && share < 1 && used < coarsest) {
      used = Math.max(finest, 2 * used);
      ({ ends, share } = segmentsOf(paths, needed, order, passes, used, most));
    }
    return { segments: segmentTexture(ends), count: ends.length / 2, share, tolerance, most };
  }

  private forget() {
    this.levels.forEach((level) => level?.segments.dispose());
    this.levels.fill(null);
  }

  dispose() {
    this.forget();
    this.points.dispose();
    this.object.material.dispose();
  }
}
