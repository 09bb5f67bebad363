// The scene of a 3D model: loads its terrain, places marks, and follows the settings of the page.

import { effect } from '@preact/signals';
import { Box3, Group, Vector3, type Object3D } from 'three';
import type { Model, Point3, Run } from '../api/types';
import { shownPaths, type DrawnPaths } from '../paths/drawnPaths';
import { file } from '../project/document';
import { reportFailure } from '../state/messages';
import { model } from '../project/model';
import { shown } from '../runs/runs';
import { markColours } from '../view/colours';
import { drapedOpacity, shownMap } from '../maps/shownMap';
import type { Box } from '../geometry/framing';
import { cameraNumbers, cameraText, tellCamera, wantCamera, wantedCamera } from '../view/camera';
import { sceneCamera, setSceneCamera } from '../view/sceneCamera';
import { watchOver } from '../view/over';
import { contours, exaggeration, layers, shading } from '../view/settings';
import { shade } from '../view/theme';
import { roundStep } from '../geometry/ticks';
import { Frame } from './frame';
import { isInView, nameOf, type Place } from './fittedPlaces';
import { clear, dots, line, patch, walls } from './marks';
import { MeshTerrain } from './meshTerrain';
import { NameLayer, type Name } from './nameLayer';
import { keepsDirection, look, namedViews, type NamedView } from './namedViews';
import { mapTexture } from './mapTexture';
import * as picture from './picture';
import { resultPlaces } from './resultPlaces';
import { Stage } from './stage';
import { TerrainMaterial, type DrapedPicture } from './terrainMaterial';
import type { Terrain } from './terrain';
import { MeshTile } from './meshTile';
import { Tile, type TileHeader } from './tile';
import { TiledTerrain, type MakeTile } from './tiledTerrain';
import { overlays, tool } from '../tools/tool';

const mostTriangles = 60_000; // of a mesh that is drawn as a whole; a larger one is drawn in tiles

/// Identifies the terrain; other changes of the project do not reload it.
const terrainKey = ({ files, bounds, facets, kind, materials, project }: Model) =>
  JSON.stringify([file.peek(), files, bounds, facets, kind, materials, project.terrain, project.ground, project.area, project.forest]);

export class ModelScene {
  readonly stage: Stage;
  frame = new Frame([0, 0, 0]);
  terrain: Terrain | null = null;
  box = new Box3(new Vector3(), new Vector3(1, 1, 1));
  private material: TerrainMaterial | null = null;
  private key = '';
  private shownFile: string | null = null;
  private asking = new AbortController();
  /// The last chosen named view and its camera position.
  private viewed: { name: NamedView; eye: Vector3; target: Vector3 } | null = null;
  private readonly seeders = new Group();
  private readonly barriers = new Group();
  private readonly drawings = new Group();
  private readonly ends: (() => void)[] = [];
  /// Boxes of the page over the picture.
  private over: Box[] = [];
  private standing: Vector3[] = [];
  /// The trajectories that named views show; null: they show the whole model.
  private result: DrawnPaths | null = null;
  /// Of features of layers.
  layerNames: Name[] = [];
  private pictures: readonly DrapedPicture[] = [];
  private seederNames: Name[] = [];
  private barrierNames: Name[] = [];
  private places: Place[] = [];
  /// Called when the frame or the terrain changes.
  readonly onTerrain: (() => unknown)[] = [];

  constructor(host: HTMLElement) {
    this.stage = new Stage(host);
    this.stage.world.add(this.seeders, this.barriers, this.drawings);
    this.stage.onLost = (lost) => picture.setFailure(lost ? 'The graphics driver dropped the 3D view. It is restored automatically if possible; otherwise reload the page.' : null);
    this.stage.beforeFrame.push(() => this.prepare());
    this.stage.onResize = () => this.refit();
    this.ends.push(
      watchOver(host.parentElement ?? host, (over) => {
        this.over = over;
        if (tool.peek() === null) this.refit();
      }),
    );
    const names = new NameLayer(host);
    this.stage.afterFrame.push(() => names.draw(this.stage, this.names(), this.over));
    this.ends.push(
      effect(() => {
        if (model.value && model.value.dimension === 3) void this.show(model.value).catch(reportFailure);
      }),
      effect(() => this.paint()),
      effect(() => this.drape()),
      effect(() => this.stretch(exaggeration.value)),
      effect(() => this.draw(overlays.value)),
      effect(() => this.showResult(shown.value, shownPaths.value)),
      effect(() => {
        if (wantedCamera.value !== null && !picture.isLoading.value && this.shownFile === file.value) this.takeCamera();
      }),
      effect(() => {
        this.seeders.visible = layers.seeders.value;
        this.barriers.visible = layers.barriers.value;
        if (this.terrain) this.terrain.object.visible = layers.terrain.value;
        this.stage.invalidate();
      }),
    );
  }

  local = (point: Point3) => this.frame.local(point);

  private async show(next: Model) {
    const key = terrainKey(next);
    if (key !== this.key) {
      this.key = key;
      await this.load(next);
    }
    if (key !== this.key) return;
    this.terrain?.useModel?.(next.id);
    this.mark(next);
  }

  private async load(next: Model) {
    this.asking.abort();
    const asking = (this.asking = new AbortController());
    const { min, max } = next.bounds;
    const frame = new Frame(min.map((low, k) => (low + max[k]!) / 2) as Point3);
    const material = new TerrainMaterial(next.kind === 'raster');
    picture.setLoading(true);
    try {
      const ofTiles = (make: MakeTile) => TiledTerrain.of(next.id, frame, [min[2], max[2]], make, asking.signal, () => this.stage.invalidate());
      const terrain =
        next.kind === 'raster'
          ? await ofTiles((answer, base) => new Tile(answer, base, (answer.header as TileHeader).cell, material))
          : next.facets > mostTriangles
            ? await ofTiles((answer, base) => new MeshTile(answer, base, material))
            : await MeshTerrain.of(next.id, frame, material, asking.signal);
      if (asking.signal.aborted) return terrain.dispose();
      this.takeTerrain(next, frame, terrain, material);
    } catch (error) {
      if (asking.signal.aborted) return;
      this.key = '';
      throw error;
    } finally {
      if (this.asking === asking) picture.setLoading(false);
    }
  }

  private takeTerrain(next: Model, frame: Frame, terrain: Terrain, material: TerrainMaterial) {
    const moved = frame.local(this.frame.base);
    if (this.terrain) this.stage.world.remove(this.terrain.object);
    this.terrain?.dispose();
    this.material?.dispose();
    [this.frame, this.terrain, this.material] = [frame, terrain, material];
    terrain.object.visible = layers.terrain.peek();
    terrain.object.name = 'Terrain';
    this.stage.world.add(terrain.object);
    this.box = new Box3(frame.local(next.bounds.min), frame.local(next.bounds.max));
    this.box.getBoundingSphere(this.stage.extent);
    const isOtherProject = this.shownFile !== file.peek();
    this.shownFile = file.peek();
    material.uniforms.range.value.set(this.box.min.z, this.box.max.z);
    material.uniforms.exaggeration.value = exaggeration.peek();
    picture.setElevations([next.bounds.min[2], next.bounds.max[2]]);
    this.paint();
    this.drape();
    material.drape(this.pictures);
    if (isOtherProject) this.view('oblique');
    else {
      // The same project: the camera stays.
      moved.z *= this.stage.world.scale.z;
      this.stage.camera.position.add(moved);
      this.stage.controls.target.add(moved);
    }
    this.draw(overlays.peek());
    for (const task of this.onTerrain) task();
    this.stage.invalidate();
  }

  private paint() {
    // Below a map the ground is grey, so that its colours are not mistaken for the map's.
    const [how, light] = [shownMap.value ? 'hillshade' : shading.value, shade.value];
    void contours.value;
    this.material?.paint(how, light, model.peek()?.materials.length ?? 1);
    this.stage.invalidate();
  }

  /// Drapes the chosen map over the terrain.
  private drape() {
    const [map, opacity] = [shownMap.value, drapedOpacity.value];
    const { uniforms } = this.material ?? {};
    if (!uniforms) return;
    if (uniforms.map.value?.userData.of !== map) {
      uniforms.map.value?.dispose();
      uniforms.map.value = map ? mapTexture(map) : null;
    }
    uniforms.mapOpacity.value = map ? opacity : 0;
    if (map) {
      const { origin, cell, columns, rows } = map.header;
      const [x, y] = [origin[0] - this.frame.base[0], origin[1] - this.frame.base[1]];
      uniforms.mapArea.value.set(x, y, columns * cell[0], rows * cell[1]);
    }
    this.stage.invalidate();
  }

  /// Drapes pictures of layers over the terrain, the lowest first.
  drapePictures(list: readonly DrapedPicture[]) {
    this.pictures = list;
    this.material?.drape(list);
    this.stage.invalidate();
  }

  /// Changes with the terrain.
  get terrainKey(): string {
    return this.key;
  }

  private stretch(factor: number) {
    const { stage } = this;
    const before = stage.world.scale.z;
    stage.world.scale.z = factor;
    stage.camera.position.z += stage.controls.target.z * (factor / before - 1);
    stage.controls.target.z *= factor / before;
    if (this.material) this.material.uniforms.exaggeration.value = factor;
    stage.invalidate();
  }

  private mark(next: Model) {
    clear(this.seeders);
    clear(this.barriers);
    for (const { points, lines, type } of next.seeders) {
      const look = { colour: markColours.seeder, size: 3 };
      for (const each of lines) this.seeders.add(line(each.map(this.local), look, type === 'polygon'));
      if (points.length > 0) this.seeders.add(dots(points.map(this.local), { ...look, size: 10 }));
    }
    for (const kind of ['barrier', 'collector'] as const) {
      const list = next.barriers.filter((one) => one.kind === kind);
      const local = list.map(({ foot, top }) => ({ foot: foot.map(this.local), top: top.map(this.local) }));
      this.barriers.add(walls(local, markColours[kind]));
    }
    const named = (text: string, places: Point3[]): Name[] => {
      const middle = places[Math.floor(places.length / 2)];
      return middle ? [{ text, at: this.local(middle) }] : [];
    };
    this.seederNames = next.seeders.flatMap(({ name, points, lines }) => named(name, points.length > 0 ? points : (lines[0] ?? [])));
    this.barrierNames = next.barriers.flatMap(({ name, top }) => named(name, top));
    this.standing = [...next.barriers.flatMap(({ top }) => top), ...next.seeders.flatMap(({ points }) => points)].map(this.local);
    this.stage.invalidate();
  }

  /// The names to draw.
  names(): Name[] {
    const places = this.places.flatMap((place) => nameOf(this.stage, place) ?? []);
    const barriers = this.barrierNames.filter(({ text }) => !places.some((place) => place.text === text));
    return [...places, ...(layers.barriers.peek() ? barriers : []), ...(layers.seeders.peek() ? this.seederNames : []), ...this.layerNames];
  }

  private draw(lists: typeof overlays.value) {
    clear(this.drawings);
    const drawn = Object.values(lists).flat();
    for (const { points, kind, isBare, colour = markColours.tool, width = 2.5, place } of drawn) {
      const places = points.map(this.local);
      const look = { colour, size: width, above: true };
      if (place && kind !== 'points') this.drawings.add(line(places, { ...look, size: width + 4, colour: '#ffffff' }, kind === 'polygon'));
      if (kind === 'polygon' && places.length === 3) this.drawings.add(patch(places, colour));
      if (kind !== 'points') this.drawings.add(line(places, look, kind === 'polygon'));
      if (kind !== 'polygon' && !isBare && places.length > 0) this.drawings.add(dots(places, { ...look, size: 9 }));
    }
    this.places = drawn.flatMap(({ points, colour = markColours.tool, place }): Place[] => (place ? [{ ...place, colour, points: points.map(this.local) }] : []));
    if (this.terrain && tool.peek() === null && !this.showsPlaces()) this.refit();
    this.stage.invalidate();
  }

  /// Before each frame.
  private prepare() {
    const { stage, material } = this;
    this.terrain?.select(stage.camera, (stage.size.height * stage.renderer.getPixelRatio()) / stage.detail.pixels, stage.world.scale.z, stage.detail.cells);
    const metresPerPixel = stage.metresPerPixel;
    const interval = contours.peek() ? roundStep(Math.max(14 * metresPerPixel, (this.box.max.z - this.box.min.z) / 60)) : 0;
    if (material) {
      material.uniforms.interval.value = interval;
      material.uniforms.phase.value = interval > 0 ? this.frame.base[2] % (5 * interval) : 0;
    }
    if (picture.contourInterval.peek() !== interval) picture.setContourInterval(interval);
    const heading = (-stage.controls.getAzimuthalAngle() * 180) / Math.PI;
    const known = sceneCamera.peek();
    if (known.metresPerPixel !== metresPerPixel || known.heading !== heading)
      setSceneCamera({ metresPerPixel, heading });
    if (this.shownFile === file.peek()) tellCamera(this.cameraNow());
  }

  /// What the view shows, for the page's address.
  private cameraNow(): string | null {
    const name = this.unmovedView();
    if (name === 'oblique') return null;
    if (name !== null && !keepsDirection(name)) return name;
    const { camera: eye, controls } = this.stage;
    const places = [eye.position, controls.target].map(({ x, y, z }) => this.frame.project({ x, y, z: z / this.stage.world.scale.z }));
    return cameraText(places.flat());
  }

  /// Shows what an address asks for.
  private takeCamera() {
    const wanted = wantedCamera.peek();
    wantCamera(null);
    if (wanted === null) return;
    const name = (Object.keys(namedViews) as NamedView[]).find((each) => each === wanted);
    if (name) return this.view(name);
    const numbers = cameraNumbers(wanted, 6);
    if (!numbers) return;
    const { camera: eye, controls, world } = this.stage;
    const place = (from: number) => this.local(numbers.slice(from, from + 3) as unknown as Point3).multiply(new Vector3(1, 1, world.scale.z));
    eye.position.copy(place(0));
    controls.target.copy(place(3));
    controls.update();
    this.stage.invalidate();
  }

  view(name: NamedView) {
    const { camera, controls } = this.stage;
    const ground = this.terrain?.samplePoints() ?? [];
    const subject = this.result && name !== 'whole' ? resultPlaces(this.result, this.local(this.result.header.origin)) : { box: this.box, places: ground };
    const asked = this.places.filter(({ isFitted }) => isFitted).flatMap(({ points }) => points);
    look(this.stage, name, subject, [...this.standing, ...asked], ground, this.over);
    this.viewed = { name, eye: camera.position.clone(), target: controls.target.clone() };
  }

  /// Unless the user moved the view, it shows the result of another run once that is there.
  private showResult(run: Run | null, paths: DrawnPaths | null) {
    if (run && (!paths || paths.header.so_far)) return; // the earlier result stays until then
    if (paths === this.result) return;
    this.result = paths;
    if (this.terrain && tool.peek() === null) this.refit();
  }

  /// Fits a named view again after the size of the picture or the boxes over it changed, unless the user moved it.
  private refit() {
    const name = this.unmovedView();
    if (name) this.view(name);
  }

  /// The last chosen named view; null if the user has moved it since.
  private unmovedView(): NamedView | null {
    const { camera, controls } = this.stage;
    if (!this.viewed) return null;
    const { name, eye, target } = this.viewed;
    const moved = eye.distanceTo(camera.position) + target.distanceTo(controls.target);
    return moved < 1e-4 * eye.distanceTo(target) ? name : null;
  }

  /// Whether the places that must not be overlooked are in the picture.
  showsPlaces(): boolean {
    this.stage.camera.updateMatrixWorld();
    return this.places.every((each) => !each.isFitted || isInView(this.stage, each));
  }

  /// Runs a task with the view rendered at another size; `isFitted`: from the same direction, fitted to the result.
  inSize<T>(size: { width: number; height: number }, task: () => T, isFitted = false): T {
    const [name, { stage, viewed, over }] = [this.unmovedView() ?? (isFitted ? 'fit' : null), this];
    const { width, height } = stage.size;
    try {
      return stage.inSize(size, () => {
        this.over = [];
        if (name) this.view(name);
        // The whole width of the view stays visible.
        else stage.dolly(Math.max(1, (width * size.height) / (height * size.width)));
        return task();
      });
    } finally {
      [this.viewed, this.over] = [viewed, over];
    }
  }

  /// The number of terrain tiles that are not loaded yet for a picture `pixels` high.
  missing(pixels: number): number {
    const { stage } = this;
    stage.camera.updateMatrixWorld();
    this.terrain?.select(stage.camera, pixels, stage.world.scale.z, 1);
    return this.terrain?.missing ?? 0;
  }

  add(object: Object3D) {
    this.stage.world.add(object);
  }

  dispose() {
    this.asking.abort();
    this.ends.forEach((end) => end());
    this.terrain?.dispose();
    this.material?.dispose();
    for (const group of [this.seeders, this.barriers, this.drawings]) clear(group);
    this.stage.dispose();
  }
}
