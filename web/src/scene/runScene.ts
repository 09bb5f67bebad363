// What the scene shows of runs: paths, rocks in motion, and the rock that is chosen.

import { effect, untracked } from '@preact/signals';
import { Group, Vector3 } from 'three';
import { colouring } from '../paths/colouring';
import { comparedPaths, indexOfRock, shownPaths, type DrawnPaths } from '../paths/drawnPaths';
import { isWhole, time } from '../paths/playback';
import { shownPassing } from '../paths/shownPassing';
import { chosenRock } from '../state/view';
import { cssColour, shade } from '../view/theme';
import { markColours } from '../view/colours';
import { layers } from '../view/settings';
import { clear, line } from './marks';
import type { ModelScene } from './modelScene';
import { pathLines } from './pathLines';
import { PathLook } from './pathShader';
import { rockNear } from './pickPath';
import { RockDots } from './rockDots';

/// The paths of one run as they are drawn.
class RunPaths {
  readonly group = new Group();
  readonly look: PathLook;
  readonly dots: RockDots;

  constructor(readonly paths: DrawnPaths, shift: ArrayLike<number>, width: number) {
    this.look = new PathLook(paths);
    this.dots = new RockDots(paths, this.look, shift);
    const count = paths.rocks.length;
    this.look.uniforms.width.value = width;
    this.look.uniforms.opacity.value = count > 2000 ? 0.45 : count > 300 ? 0.7 : 0.95;
    this.group.add(pathLines(paths, this.look, shift), this.dots.object);
  }

  dispose() {
    clear(this.group);
    this.look.dispose();
  }
}

export class RunScene {
  private shown: RunPaths | null = null;
  private compared: RunPaths | null = null;
  private readonly all = new Group();
  private readonly chosen = new Group();
  private readonly ends: (() => void)[];

  constructor(private readonly scene: ModelScene) {
    const { stage } = scene;
    scene.add(this.all);
    scene.add(this.chosen);
    scene.onTerrain.push(() => this.place());
    stage.beforeFrame.push(() => this.measure());
    this.ends = [
      effect(() => {
        void shownPaths.value;
        void comparedPaths.value;
        untracked(() => this.place());
      }),
      effect(() => this.colour()),
      effect(() => {
        this.shown?.look.pass(shownPaths.value ? shownPassing.value : null);
        stage.invalidate();
      }),
      effect(() => this.move(time.value, isWhole.value)),
      effect(() => {
        this.all.visible = layers.paths.value;
        stage.invalidate();
      }),
      effect(() => {
        void shownPaths.value;
        void shade.value;
        this.mark(chosenRock.value);
      }),
    ];
  }

  private make(paths: DrawnPaths | null, width: number): RunPaths | null {
    if (!paths || !this.scene.terrain) return null;
    const made = new RunPaths(paths, this.scene.local(paths.header.origin).toArray(), width);
    this.all.add(made.group);
    return made;
  }

  /// Where the terrain is; places are relative to its frame.
  private place() {
    for (const old of [this.shown, this.compared]) {
      if (!old) continue;
      this.all.remove(old.group);
      old.dispose();
    }
    const ratio = this.scene.stage.renderer.getPixelRatio();
    this.compared = this.make(comparedPaths.peek(), 1.4 * ratio);
    this.shown = this.make(shownPaths.peek(), 1.6 * ratio);
    this.compared?.look.colourAll(markColours.compared);
    untracked(() => {
      this.shown?.look.pass(shownPassing.value);
      this.colour();
      this.move(time.value, isWhole.value);
      this.mark(chosenRock.value);
    });
  }

  /// The rock whose path is meant by a place of the window.
  rockAt(clientX: number, clientY: number): number | null {
    const [{ stage }, paths] = [this.scene, shownPaths.peek()];
    if (!paths || !layers.paths.peek()) return null;
    const box = stage.renderer.domElement.getBoundingClientRect();
    const shift = this.scene.local(paths.header.origin);
    return rockNear(stage, paths, shownPassing.peek(), shift, clientX - box.left, clientY - box.top, 8);
  }

  private colour() {
    if (colouring.value) this.shown?.look.colourBy(colouring.value);
    this.scene.stage.invalidate();
  }

  private move(now: number, whole: boolean) {
    for (const run of [this.shown, this.compared]) {
      if (!run) continue;
      run.look.uniforms.time.value = whole ? Infinity : now;
      // When all have stopped, they lie where they ended.
      run.dots.object.visible = !whole || layers.ends.value;
      run.dots.at(whole ? Infinity : now);
    }
    this.scene.stage.invalidate();
  }

  private mark(rock: number | null) {
    clear(this.chosen);
    const paths = shownPaths.peek();
    const k = paths && rock !== null ? indexOfRock(paths, rock) : -1;
    if (paths && k >= 0 && this.scene.terrain) {
      const shift = this.scene.local(paths.header.origin);
      const points: Vector3[] = [];
      for (let at = paths.starts[k]!; at < paths.starts[k + 1]!; ++at)
        points.push(new Vector3().fromArray(paths.positions, 3 * at).add(shift));
      this.chosen.add(line(points, { colour: cssColour('--panel'), size: 6 }), line(points, { colour: cssColour('--accent'), size: 3.5 }));
    }
    this.scene.stage.invalidate();
  }

  private measure() {
    const { width, height } = this.scene.stage.size;
    const ratio = this.scene.stage.renderer.getPixelRatio();
    for (const run of [this.shown, this.compared])
      if (run) run.look.uniforms.pixels.value = [width * ratio, height * ratio];
  }

  dispose() {
    this.ends.forEach((end) => end());
    this.shown?.dispose();
    this.compared?.dispose();
    clear(this.chosen);
  }
}
