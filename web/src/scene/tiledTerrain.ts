// A raster or a large mesh in tiles, coarse far away and fine nearby, loaded on demand.

import { Box3, Frustum, Group, Matrix4, Vector3, type Camera, type Ray } from 'three';
import type { Arrays } from '../api/arrays';
import { getArrays, getJson } from '../api/client';
import type { Tiles } from '../api/types';
import { reportFailure } from '../state/messages';
import type { Frame } from './frame';
import type { Hit, PickedTile, Terrain, TerrainTile } from './terrain';

const pixelsPerCell = 2.2; // finer tiles are used where a cell is larger
const requestsAtOnce = 6;
const mostBytes = 200e6; // of cached tiles

interface Node {
  level: number; // index into `levels`, coarsest first
  column: number;
  row: number;
  box: Box3;
  tile?: TerrainTile;
  children?: Node[];
  priority: number;
  asked: boolean;
}

/// Makes a tile of the server's answer.
export type MakeTile = (answer: Arrays<never>, frame: Frame) => TerrainTile;

export class TiledTerrain implements Terrain {
  readonly object = new Group();
  private readonly levels: { number: number; stride: number; columns: number; rows: number }[];
  private readonly roots: Node[] = [];
  private wanted: Node[] = [];
  private loading = 0;
  private bytes = 0;
  private readonly loaded = new Set<Node>();
  private drawn: Node[] = [];
  private turn = 0;

  private constructor(
    private model: string,
    private readonly tiles: Tiles,
    private readonly frame: Frame,
    private readonly zRange: [number, number],
    private readonly make: MakeTile,
    private readonly signal: AbortSignal,
    private readonly changed: () => void,
  ) {
    this.levels = tiles.levels.map((level, number) => ({ ...level, number })).sort((a, b) => b.stride - a.stride);
    const { columns, rows } = this.levels[0]!;
    for (let row = 0; row < rows; ++row)
      for (let column = 0; column < columns; ++column) this.roots.push(this.node(0, column, row));
  }

  /// Resolves when the coarsest tiles are loaded.
  static async of(
    model: string,
    frame: Frame,
    z: [number, number],
    make: MakeTile,
    signal: AbortSignal,
    changed: () => void,
  ): Promise<TiledTerrain> {
    const tiles = await getJson<Tiles>(`/api/models/${model}/tiles`, signal);
    const terrain = new TiledTerrain(model, tiles, frame, z, make, signal, changed);
    await Promise.all(terrain.roots.map((root) => terrain.load(root)));
    return terrain;
  }

  useModel(model: string) {
    this.model = model;
  }

  private node(level: number, column: number, row: number): Node {
    const { origin, cell, tile, columns, rows } = this.tiles;
    const { stride } = this.levels[level]!;
    const side = tile * stride;
    const place = (k: number, axis: 0 | 1, most: number) =>
      origin[axis] - this.frame.base[axis] + cell[axis] * Math.min(k * side, most - 1);
    const base = this.frame.base[2];
    const box = new Box3(
      new Vector3(place(column, 0, columns), place(row, 1, rows), this.zRange[0] - base),
      new Vector3(place(column + 1, 0, columns), place(row + 1, 1, rows), this.zRange[1] - base),
    );
    return { level, column, row, box, priority: 0, asked: false };
  }

  private childrenOf(node: Node): Node[] {
    if (node.children) return node.children;
    const list: Node[] = [];
    const finer = this.levels[node.level + 1];
    if (finer) {
      const share = this.levels[node.level]!.stride / finer.stride;
      for (let r = node.row * share; r < Math.min(finer.rows, (node.row + 1) * share); ++r)
        for (let c = node.column * share; c < Math.min(finer.columns, (node.column + 1) * share); ++c) {
          const child = this.node(node.level + 1, c, r);
          if (node.tile && !node.tile.box.isEmpty()) [child.box.min.z, child.box.max.z] = [node.tile.box.min.z - 1, node.tile.box.max.z + 1];
          list.push(child);
        }
    }
    return (node.children = list);
  }

  select(camera: Camera & { fov: number }, pixels: number, exaggeration: number, cells: number) {
    ++this.turn;
    const view = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    view.multiply(new Matrix4().makeScale(1, 1, exaggeration));
    const frustum = new Frustum().setFromProjectionMatrix(view);
    const eye = camera.position.clone();
    eye.z /= exaggeration;
    const focal = pixels / (2 * Math.tan((camera.fov * Math.PI) / 360));
    this.wanted = [];
    const most = pixelsPerCell * (this.roots[0]!.tile?.thin ? 1 : cells);
    const now: Node[] = [];
    const visit = (node: Node) => {
      if (!frustum.intersectsBox(node.box)) return;
      const cell = this.tiles.cell[0] * this.levels[node.level]!.stride;
      const gap = node.box.clampPoint(eye, new Vector3()).sub(eye);
      gap.z *= exaggeration;
      const size = (cell * focal) / Math.max(gap.length(), 0.1);
      if (node.tile) node.tile.used = this.turn;
      if (size > most && node.level + 1 < this.levels.length) {
        const children = this.childrenOf(node).filter((child) => frustum.intersectsBox(child.box));
        for (const child of children)
          if (!child.tile) {
            child.priority = size;
            this.wanted.push(child);
          }
        if (children.every((child) => child.tile)) return children.forEach(visit);
      }
      if (node.tile) now.push(node);
    };
    this.roots.forEach(visit);
    for (const node of this.drawn) if (!now.includes(node) && node.tile) node.tile.mesh.visible = false;
    for (const { tile } of now) {
      tile!.mesh.visible = true;
      tile!.thin?.(cells);
    }
    this.drawn = now;
    this.wanted.sort((a, b) => b.priority - a.priority);
    this.loadNext();
    this.evict();
  }

  get missing(): number {
    return this.wanted.length;
  }

  private loadNext() {
    while (this.loading < requestsAtOnce) {
      const next = this.wanted.find((node) => !node.asked && !node.tile);
      if (!next) return;
      void this.load(next).then(
        () => this.changed(),
        (error: unknown) => {
          if (!this.signal.aborted) reportFailure(error);
        },
      );
    }
  }

  private async load(node: Node) {
    node.asked = true;
    ++this.loading;
    const { number } = this.levels[node.level]!;
    try {
      const answer = await getArrays<never>(`/api/models/${this.model}/tiles/${number}/${node.column}/${node.row}`, this.signal);
      node.tile = this.make(answer, this.frame);
      if (!node.tile.box.isEmpty()) node.box = node.tile.box;
      node.tile.mesh.visible = false;
      node.tile.used = this.turn;
      this.object.add(node.tile.mesh);
      this.loaded.add(node);
      this.bytes += node.tile.bytes;
      node.asked = false;
    } finally {
      --this.loading;
    }
  }

  /// Drops the least recently used tiles.
  private evict() {
    if (this.bytes < mostBytes) return;
    const old = [...this.loaded].filter((node) => node.level > 0 && node.tile!.used < this.turn);
    old.sort((a, b) => a.tile!.used - b.tile!.used);
    for (const node of old) {
      if (this.bytes < 0.8 * mostBytes) return;
      this.bytes -= node.tile!.bytes;
      this.object.remove(node.tile!.mesh);
      node.tile!.dispose();
      delete node.tile;
      this.loaded.delete(node);
    }
  }

  pick(ray: Ray): Hit | null {
    let [picked, isCoarse]: [PickedTile, boolean] = [{ distance: Infinity }, false];
    for (const { tile, level } of this.drawn) {
      const found = tile?.pick(ray);
      if (found && found.distance < picked.distance) [picked, isCoarse] = [found, this.levels[level]!.stride > 1];
    }
    return picked.distance < Infinity ? { point: ray.at(picked.distance, new Vector3()), ...picked, isCoarse } : null;
  }

  samplePoints(): Vector3[] {
    const most = Math.ceil(Math.sqrt(600 / this.roots.length));
    return this.roots.flatMap(({ tile }) => tile?.samplePoints(most) ?? []);
  }

  dispose() {
    for (const { tile } of this.loaded) tile!.dispose();
    this.loaded.clear();
    this.drawn = [];
  }
}
