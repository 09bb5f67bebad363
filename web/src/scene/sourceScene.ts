// Release places in the scene, coloured by the share of their rocks that reaches the asked line.

import { effect, signal } from '@preact/signals';
import { BufferAttribute, BufferGeometry, GLSL3, Group, Points, ShaderMaterial, Vector2, Vector3 } from 'three';
import { drawnSources, type DrawnSources } from '../askLine/sources';
import { filter } from '../runs/filter';
import { colourAt, shareRamp } from '../view/colours';
import { shade } from '../view/theme';
import { clear } from './marks';
import type { ModelScene } from './modelScene';

const vertex = /* glsl */ `
in vec3 colour;
in float metres;        // side of a cell; 0: a disc
in float chosen;
uniform vec2 pixels;    // size of the drawing buffer
uniform float ratio;    // drawing buffer pixels per CSS pixel
out vec3 inside;
flat out float side;    // pixels
flat out float isCell;
flat out float isChosen;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * eye;
  float pixelsPerMetre = projectionMatrix[1][1] * 0.5 * pixels.y / gl_Position.w;
  side = metres > 0.0 ? clamp(0.9 * metres * pixelsPerMetre, 3.0 * ratio, 60.0 * ratio) : 15.0 * ratio;
  // Moved towards the camera, so that the ground in front does not cut it.
  vec4 front = projectionMatrix * (eye + vec4(0.0, 0.0, side / pixelsPerMetre, 0.0));
  if (front.w > 0.0) gl_Position.z = front.z / front.w * gl_Position.w;
  gl_PointSize = side;
  inside = colour;
  isCell = metres > 0.0 ? 1.0 : 0.0;
  isChosen = chosen;
}`;
const fragment = /* glsl */ `
precision highp float;
uniform float ratio;
uniform vec3 rim;
uniform vec3 mark;
in vec3 inside;
flat in float side;
flat in float isCell;
flat in float isChosen;
out vec4 result;
void main() {
  vec2 off = abs(gl_PointCoord - 0.5) * side;
  float r = isCell > 0.5 ? max(off.x, off.y) : length(off);
  float edge = 0.5 * side;
  if (r > edge) discard;
  float wide = isChosen > 0.5 ? max(2.5 * ratio, 0.2 * side) : isCell > 0.5 ? (side > 8.0 * ratio ? ratio : 0.0) : 1.8 * ratio;
  result = vec4(r > edge - wide ? (isChosen > 0.5 ? mark : rim) : inside, 0.95);
}`;

const near = 5; // CSS pixels beside a place that still choose it

export class SourceScene {
  private readonly group = new Group();
  private readonly terrain = signal(0);
  private readonly end: () => void;

  constructor(private readonly scene: ModelScene) {
    scene.add(this.group);
    scene.onTerrain.push(() => (this.terrain.value = this.terrain.peek() + 1));
    this.end = effect(() => {
      void this.terrain.value;
      const light = shade.value;
      clear(this.group);
      if (drawnSources.value) this.draw(drawnSources.value, new Set(filter.value.releases), light);
      scene.stage.invalidate();
    });
  }

  private draw({ positions, sizes, shares, numbers }: DrawnSources, chosen: ReadonlySet<number>, light: 'light' | 'dark') {
    const geometry = new BufferGeometry();
    const put = (name: string, values: number[], each: number) =>
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(values), each));
    put('position', positions.flatMap((place) => this.scene.local(place).toArray()), 3);
    put('colour', shares.flatMap((share) => colourAt(shareRamp[light], share).map((part) => part / 255)), 3);
    put('metres', sizes, 1);
    put('chosen', numbers.map((number) => (chosen.has(number) ? 1 : 0)), 1);
    const rim = light === 'light' ? 0.35 : 0.85;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: {
        pixels: { value: new Vector2() },
        ratio: { value: 1 },
        rim: { value: [rim, rim, rim] },
        mark: { value: [1, 0.55, 0] },
      },
      transparent: true,
      depthWrite: false,
    });
    const made = new Points(geometry, material);
    made.onBeforeRender = (renderer) => {
      renderer.getDrawingBufferSize(material.uniforms.pixels!.value as Vector2);
      material.uniforms.ratio!.value = renderer.getPixelRatio();
    };
    made.renderOrder = 7;
    made.frustumCulled = false;
    this.group.add(made);
  }

  /// The number of the release place at a position of the window; null if none.
  placeAt(clientX: number, clientY: number): number | null {
    const drawn = drawnSources.peek();
    if (!drawn) return null;
    const { stage } = this.scene;
    const box = stage.renderer.domElement.getBoundingClientRect();
    const [x, y] = [clientX - box.left, clientY - box.top];
    const eye = stage.camera.position;
    const pixelsAtOne = stage.size.height / (2 * Math.tan((stage.camera.fov * Math.PI) / 360));
    let best = { number: -1, distance: Infinity };
    drawn.positions.forEach((place, k) => {
      const local = this.scene.local(place);
      const pixel = stage.pixelOf(local);
      if (!pixel) return;
      const away = Math.max(new Vector3(local.x, local.y, local.z * stage.world.scale.z).distanceTo(eye), 0.1);
      const size = drawn.sizes[k]!;
      const half = size > 0 ? Math.min(30, (0.45 * size * pixelsAtOne) / away) : 7.5;
      const distance = Math.max(Math.abs(pixel.x - x), Math.abs(pixel.y - y));
      if (distance <= Math.max(half, near) && distance < best.distance) best = { number: drawn.numbers[k]!, distance };
    });
    return best.number < 0 ? null : best.number;
  }

  dispose() {
    this.end();
    clear(this.group);
  }
}
