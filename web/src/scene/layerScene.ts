// Reference layers in the scene: pictures draped over the terrain, lines and points on it, with their names.

import { effect, signal } from '@preact/signals';
import { BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LinearFilter, LinearMipmapLinearFilter, LineSegments, Texture, type Object3D } from 'three';
import { getArrays, getBlob } from '../api/client';
import type { Point3 } from '../api/types';
import { mostDraped } from '../layers/draped';
import { addressOf, isDrawn, projectLayers, type Layer } from '../layers/layers';
import { linesOf, type LayerLines, type LinesHeader } from '../layers/layerLines';
import { reportFailure } from '../state/messages';
import { clear, dots, pieces } from './marks';
import type { ModelScene } from './modelScene';
import type { Name } from './nameLayer';
import type { DrapedPicture } from './terrainMaterial';

const mostWide = 20_000; // segments drawn with a width: more would be slow without a graphics card

async function textureOf(address: string, signal: AbortSignal): Promise<Texture> {
  const bitmap = await createImageBitmap(await getBlob(address, signal), {
    imageOrientation: 'flipY',
    premultiplyAlpha: 'premultiply',
    colorSpaceConversion: 'none',
  });
  const made = new Texture(bitmap);
  made.flipY = false;
  made.magFilter = LinearFilter;
  made.minFilter = LinearMipmapLinearFilter;
  made.anisotropy = 4;
  made.needsUpdate = true;
  return made;
}

/// What was loaded of a layer, while its key stays the same.
interface Loaded {
  key: string;
  texture?: Texture;
  lines?: LayerLines;
}

export class LayerScene {
  private readonly group = new Group();
  private readonly loaded = new Map<string, Loaded>();
  private readonly loading = new Map<string, { key: string; controller: AbortController }>();
  /// Incremented when something is loaded, or the terrain is another one.
  private readonly version = signal(0);
  private readonly end: () => void;

  constructor(private readonly scene: ModelScene) {
    this.group.name = 'Layers';
    scene.add(this.group);
    scene.onTerrain.push(() => (this.version.value = this.version.peek() + 1));
    this.end = effect(() => {
      void this.version.value;
      this.show(projectLayers.value);
    });
  }

  /// The heights of lines are those of a terrain; the key of the server is that of the file and of the area.
  private keyOf(layer: Layer): string {
    const { found } = layer;
    return found?.kind === 'vector' ? `${found.key} ${this.scene.terrainKey}` : (found?.key ?? '');
  }

  private show(list: readonly Layer[]) {
    const wanted = new Set(list.map(({ name }) => name));
    for (const name of [...this.loaded.keys(), ...this.loading.keys()]) if (!wanted.has(name)) this.drop(name);
    const drawn = list.filter(isDrawn);
    for (const layer of drawn) if (this.loaded.get(layer.name)?.key !== this.keyOf(layer)) this.load(layer);
    this.drape(drawn);
    clear(this.group);
    const names: Name[] = [];
    for (const layer of drawn) {
      const lines = this.loaded.get(layer.name)?.lines;
      if (lines) this.draw(layer, lines, names);
    }
    this.scene.layerNames = names;
    this.scene.stage.invalidate();
  }

  private load(layer: Layer) {
    const [key, before] = [this.keyOf(layer), this.loading.get(layer.name)];
    if (before?.key === key) return;
    before?.controller.abort();
    const own = { key, controller: new AbortController() };
    this.loading.set(layer.name, own);
    const { signal } = own.controller;
    const read: Promise<Loaded> =
      layer.found!.kind === 'raster'
        ? textureOf(addressOf(layer, 'picture'), signal).then((texture) => ({ key, texture }))
        : getArrays<LinesHeader>(addressOf(layer, 'lines'), signal).then((answer) => ({ key, lines: linesOf(answer) }));
    const end = () => {
      if (this.loading.get(layer.name) === own) this.loading.delete(layer.name);
    };
    read.then(
      (found) => {
        end();
        if (signal.aborted) return found.texture?.dispose();
        this.loaded.get(layer.name)?.texture?.dispose();
        this.loaded.set(layer.name, found);
        this.version.value = this.version.peek() + 1;
      },
      (error: unknown) => {
        end();
        if (!signal.aborted) reportFailure(error);
      },
    );
  }

  private drop(name: string) {
    this.loading.get(name)?.controller.abort();
    this.loading.delete(name);
    this.loaded.get(name)?.texture?.dispose();
    this.loaded.delete(name);
  }

  private drape(drawn: readonly Layer[]) {
    const pictures = drawn.flatMap(({ name, found, opacity }): DrapedPicture[] => {
      const texture = this.loaded.get(name)?.texture;
      if (!texture || found?.kind !== 'raster') return [];
      const [[west, south], [east, north]] = found.area;
      const corner = this.scene.local([west, south, 0]);
      return [{ texture, corner: [corner.x, corner.y], size: [east - west, north - south], opacity }];
    });
    this.group.userData.textures = pictures.map(({ texture }) => texture);
    this.scene.drapePictures(pictures.slice(-mostDraped));
  }

  private draw({ colour, opacity }: Layer, { segments, points, origin, names: named }: LayerLines, names: Name[]) {
    const at = this.scene.local(origin as Point3);
    const put = (made: Object3D) => {
      made.position.copy(at);
      this.group.add(made);
    };
    if (segments.length > 0) put(segments.length / 6 <= mostWide ? pieces(segments, { colour, size: 2 }, opacity) : thin(segments, colour, opacity));
    if (points.length > 0) put(dots(points, { colour, size: 9 }));
    for (const { text, at: [x, y, z] } of named) names.push({ text, at: this.scene.local([x + origin[0], y + origin[1], z + origin[2]]) });
  }

  dispose() {
    this.end();
    for (const name of [...this.loaded.keys(), ...this.loading.keys()]) this.drop(name);
    clear(this.group);
  }
}

/// Lines of one pixel.
function thin(segments: Float32Array, colour: string, opacity: number): Object3D {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(segments, 3));
  const made = new LineSegments(geometry, new LineBasicMaterial({ color: new Color(colour), transparent: true, opacity }));
  made.renderOrder = 4;
  made.frustumCulled = false;
  return made;
}
