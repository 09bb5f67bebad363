// The blocks at a time, at their true size, in one call. A block that is only a few pixels large is left to the dots.

import { BufferAttribute, BufferGeometry, DataTexture, DynamicDrawUsage, FloatType, GLSL3, Mesh, NearestFilter, RGBAFormat, ShaderMaterial } from 'three';
import { BlocksAtTime } from '../paths/blocksAtTime';
import type { DrawnBlocks } from '../paths/drawnBlocks';
import { drawnRadius } from '../paths/rockSize';
import { hullVertices } from './hullVertices';
import { lightGlsl } from './light';
import { colourGlsl, nearer, tableGlsl, type PathLook } from './pathShader';
import { projected } from './projected';
import { restUnit, sizeGlsl, sizeUniforms } from './rockDots';
import type { Stage } from './stage';

const [across, texels] = [256, 3]; // blocks in a row of the texture, and texels of each

const vertex = /* glsl */ `
${colourGlsl}
${sizeGlsl}
in float block;
in vec3 side;                   // distance from the sides of the triangle, as a share
uniform highp sampler2D poses;  // of each block: centre, radius; quaternion; speed, energy, height, rock
uniform float chosen;           // the selected rock; -1: none
uniform bool isChosenOnly;
out vec3 facing;  // normal in the scene, with exaggeration
flat out float place;
flat out float isChosen;
flat out float edges;  // how visible they are
out vec3 within;
vec3 turned(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}
vec4 texelOf(int number) {
  int k = int(block + 0.5);
  return texelFetch(poses, ivec2(${texels} * (k % ${across}) + number, k / ${across}), 0);
}
void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // not seen
  vec4 centre = texelOf(0);
  vec4 middle = projectionMatrix * modelViewMatrix * vec4(centre.xyz, 1.0);
  if (!isDrawnAsBlock(centre.w, middle)) return;
  vec4 values = texelOf(2);
  vec4 rock = rockOf(values);
  isChosen = abs(values.w - chosen) < 0.5 ? 1.0 : 0.0;
  if (rock.w < 0.5 || (isChosenOnly && isChosen < 0.5)) return;
  place = placeOf(values, rock);
  edges = 0.15 * smoothstep(10.0, 40.0, centre.w * pixelsPerMetreAt(middle));
  vec4 turn = texelOf(1);
  within = side;
  vec3 n = turned(turn, normal);
  facing = vec3(n.xy, n.z / length(modelMatrix[2].xyz));
  gl_Position = projectionMatrix * modelViewMatrix * vec4(centre.xyz + turned(turn, position), 1.0);
  gl_Position.z -= ${nearer} * gl_Position.w; // as the lines, which would be drawn over it
}`;

const fragment = /* glsl */ `
precision highp float;
${tableGlsl}
${lightGlsl}
uniform vec3 rest;
uniform vec3 accent;
uniform bool isWhole;  // all rocks have stopped
in vec3 facing;
flat in float place;
flat in float isChosen;
flat in float edges;
in vec3 within;
uniform float ratio;
out vec4 colour;
void main() {
  vec3 n = normalize(facing);
  // Rocks at rest have no speed, energy or height to colour by; their colour is so bright that light would not show.
  vec3 fill = isChosen > 0.5 ? accent : isWhole && quantity < 3 ? 0.8 * rest : colourFor(place);
  // The ground gives some light back from below, and some comes from the eye, so that faces differ on all sides.
  float light = lightOn(n) + 0.14 * (1.0 - n.z) + 0.3 * max((viewMatrix * vec4(n, 0.0)).z, 0.0);
  vec3 lit = fill * light * tintOn(n);
  // Edges in a colour that contrasts, as the outlines of dots.
  vec3 off = within / max(fwidth(within), 1e-6);
  float edge = 1.0 - smoothstep(0.4 * ratio, 1.2 * ratio, min(off.x, min(off.y, off.z)));
  vec3 rim = dot(fill, vec3(0.2126, 0.7152, 0.0722)) < 0.43 ? vec3(1.0) : vec3(0.165, 0.149, 0.125);
  colour = vec4(mix(lit, rim, edges * edge), 1.0);
}`;

function poseTexture(count: number): DataTexture {
  const rows = Math.max(1, Math.ceil(count / across));
  const made = new DataTexture(new Float32Array(4 * texels * across * rows), texels * across, rows, RGBAFormat, FloatType);
  made.magFilter = made.minFilter = NearestFilter;
  return made;
}

export class BlockMesh {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly moving: BlocksAtTime;
  private readonly poses: DataTexture;

  /// `shift`: of the origin of the blocks in the scene. `accent`: the colour of the selected rock.
  constructor(
    readonly blocks: DrawnBlocks,
    look: PathLook,
    private readonly shift: ArrayLike<number>,
  ) {
    this.moving = new BlocksAtTime(blocks);
    this.poses = poseTexture(blocks.drawn.length);
    const { corners, normals, owners, sides } = hullVertices(blocks);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setAttribute('side', new BufferAttribute(sides, 3));
    geometry.setAttribute('block', new BufferAttribute(owners, 1));
    geometry.setIndex(new BufferAttribute(new Uint32Array(owners.length), 1).setUsage(DynamicDrawUsage));
    const own = {
      ...sizeUniforms(blocks.paths),
      poses: { value: this.poses },
      rest: { value: restUnit },
      accent: { value: restUnit },
      chosen: { value: -1 },
      isChosenOnly: { value: false },
    };
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: { ...look.uniforms, ...own },
    });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  /// `values`: speed, energy, height and index of each drawn rock.
  at(time: number, values: ArrayLike<number>) {
    const { blocks, moving, shift } = this;
    const data = this.poses.image.data as Float32Array;
    moving.find(time);
    for (let k = 0; k < blocks.drawn.length; ++k) {
      const rock = blocks.drawn[k]!;
      const to = 4 * texels * k;
      for (let axis = 0; axis < 3; ++axis) data[to + axis] = moving.positions[3 * k + axis]! + shift[axis]!;
      data[to + 3] = blocks.paths.radii[rock]!;
      for (let axis = 0; axis < 4; ++axis) {
        data[to + 4 + axis] = moving.turns[4 * k + axis]!;
        data[to + 8 + axis] = values[4 * rock + axis]!;
      }
    }
    this.poses.needsUpdate = true;
  }

  /// Before a frame: leaves out the blocks that are beside the picture or too small, which most are.
  select(stage: Stage) {
    const { blocks, places, object } = this;
    const { largest, least } = object.material.uniforms;
    const index = object.geometry.index!;
    const seen = projected(stage);
    const { width, height } = stage.size;
    let count = 0;
    for (let k = 0; k < blocks.drawn.length; ++k) {
      const radius = blocks.paths.radii[blocks.drawn[k]!]!;
      const { left, top, perMetre } = seen(...places(k));
      const size = radius * perMetre;
      // The shader decides; a little less is enough here.
      if (!(size > 0.98 * drawnRadius(radius, largest!.value as number, 0, least!.value as number))) continue;
      // A long block reaches farther than the sphere of its volume.
      const reach = 4 * size * Math.max(1, stage.world.scale.z);
      if (left < -reach || left > width + reach || top < -reach || top > height + reach) continue;
      for (let vertex = 3 * blocks.triangleStarts[k]!; vertex < 3 * blocks.triangleStarts[k + 1]!; ++vertex) index.array[count++] = vertex;
    }
    object.geometry.setDrawRange(0, count);
    index.needsUpdate = true;
  }

  /// Where a block's centre is in the scene.
  readonly places = (block: number): [number, number, number] => {
    const { positions } = this.moving;
    return [positions[3 * block]! + this.shift[0]!, positions[3 * block + 1]! + this.shift[1]!, positions[3 * block + 2]! + this.shift[2]!];
  };

  /// Shows the selected rock, by its index, in another colour; -1: none. `isOnly`: and no other.
  choose(rock: number, accent: number[], isOnly: boolean) {
    const { uniforms } = this.object.material;
    uniforms.chosen!.value = rock;
    uniforms.accent!.value = accent;
    uniforms.isChosenOnly!.value = isOnly;
  }

  dispose() {
    this.poses.dispose();
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
