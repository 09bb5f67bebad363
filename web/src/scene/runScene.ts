// Runs in the scene: trajectories, moving rocks, and the selected rock.

import { effect, signal, type ReadonlySignal, type Signal } from '@preact/signals';
import { Group, Vector3 } from 'three';
import { areEndsShown, arePathsShown } from '../maps/over';
import { colouring } from '../paths/colouring';
import { comparedBlocks, shownBlocks, type DrawnBlocks } from '../paths/drawnBlocks';
import { comparedPaths, indexOfRock, shownPaths, type DrawnPaths } from '../paths/drawnPaths';
import { isWhole, time } from '../paths/playback';
import { comparedPassing, shownPassing } from '../paths/shownPassing';
import { chosenRock } from '../runs/chosenRock';
import { colourOf } from '../view/colours';
import { cssColour, runColour, shade } from '../view/theme';
import { BlockMesh } from './blockMesh';
import { clear, line } from './marks';
import type { ModelScene } from './modelScene';
import { PathLines } from './pathLines';
import { PathLook } from './pathShader';
import { blockUnder } from './pickBlock';
import { rockNear } from './pickPath';
import { RockDots } from './rockDots';

/// The drawn trajectories of one run.
class RunPaths {
  readonly group = new Group();
  readonly look: PathLook;
  readonly dots: RockDots;
  readonly lines: PathLines;
  blocks: BlockMesh | null = null;

  constructor(readonly paths: DrawnPaths, shift: ArrayLike<number>, width: number) {
    this.look = new PathLook(paths);
    this.dots = new RockDots(paths, this.look, shift);
    const count = paths.rocks.length;
    this.look.uniforms.width.value = width;
    this.look.uniforms.opacity.value = count > 2000 ? 0.45 : count > 300 ? 0.7 : 0.95;
    this.lines = new PathLines(paths, this.look, shift);
    this.group.add(this.lines.object, this.dots.object);
  }

  pass(passes: Uint8Array | null) {
    this.look.pass(passes);
    this.lines.pass(passes);
  }

  /// `shift`: of the origin of the blocks.
  addBlocks(blocks: DrawnBlocks, shift: ArrayLike<number>) {
    this.removeBlocks();
    this.blocks = new BlockMesh(blocks, this.look, shift);
    this.dots.leaveToBlocks(blocks.drawn);
    this.group.add(this.blocks.object);
  }

  removeBlocks() {
    if (!this.blocks) return;
    this.group.remove(this.blocks.object);
    this.blocks.dispose();
    this.blocks = null;
    this.dots.leaveToBlocks([]);
  }

  dispose() {
    this.removeBlocks();
    this.lines.dispose();
    clear(this.group);
    this.look.dispose();
  }
}

export class RunScene {
  // The drawn runs. They are signals, so that the effects below also style runs that are drawn later.
  private readonly shown = signal<RunPaths | null>(null);
  private readonly compared = signal<RunPaths | null>(null);
  /// Incremented when the frame of the terrain changes, because positions are relative to it.
  private readonly terrain = signal(0);
  /// Incremented when blocks come or go.
  private readonly changes = signal(0);
  private readonly all = new Group();
  private readonly chosen = new Group();
  private readonly ends: (() => void)[];
  private readonly eye = new Vector3();

  constructor(private readonly scene: ModelScene) {
    const { stage } = scene;
    this.all.name = 'Trajectories';
    scene.add(this.all);
    scene.add(this.chosen);
    scene.onTerrain.push(() => (this.terrain.value = this.terrain.peek() + 1));
    stage.beforeFrame.push(() => this.measure());
    this.ends = [
      this.keepPlaced(this.compared, comparedPaths, 1.4),
      this.keepPlaced(this.shown, shownPaths, 1.6),
      effect(() => {
        const how = colouring.value;
        if (how) this.shown.value?.look.colourBy(how);
        this.compared.value?.look.colourAll(runColour('compared'));
        stage.invalidate();
      }),
      effect(() => {
        const [ofShown, ofCompared] = [shownPassing.value, comparedPassing.value];
        this.shown.value?.pass(ofShown);
        this.compared.value?.pass(ofCompared);
        stage.invalidate();
      }),
      this.keepBlocks(this.compared, comparedBlocks),
      this.keepBlocks(this.shown, shownBlocks),
      effect(() => {
        void this.changes.value;
        this.move(time.value, isWhole.value, arePathsShown.value, areEndsShown.value);
      }),
      effect(() => {
        void [this.changes.value, shade.value];
        this.chooseBlock(chosenRock.value, isWhole.value && !areEndsShown.value);
      }),
      effect(() => {
        void [shownPaths.value, this.terrain.value, shade.value];
        this.mark(chosenRock.value);
      }),
    ];
  }

  /// Redraws a run's trajectories whenever they or the frame of the terrain change.
  private keepPlaced(drawn: Signal<RunPaths | null>, paths: ReadonlySignal<DrawnPaths | null>, width: number): () => void {
    return effect(() => {
      const [now, { terrain }] = [paths.value, this.scene];
      void this.terrain.value;
      if (!now || !terrain) return;
      const made = new RunPaths(now, this.scene.local(now.header.origin).toArray(), width);
      this.all.add(made.group);
      drawn.value = made;
      return () => {
        this.all.remove(made.group);
        made.dispose();
        drawn.value = null;
      };
    });
  }

  /// Keeps the blocks of a drawn run with their terrain.
  private keepBlocks(drawn: Signal<RunPaths | null>, blocks: ReadonlySignal<DrawnBlocks | null>): () => void {
    return effect(() => {
      const [run, now] = [drawn.value, blocks.value];
      if (!run) return;
      if (now?.paths === run.paths) run.addBlocks(now, this.scene.local(now.origin).toArray());
      else run.removeBlocks();
      this.changes.value = this.changes.peek() + 1;
    });
  }

  /// The rock at a position of the window; null if none.
  rockAt(clientX: number, clientY: number): number | null {
    const [{ stage }, paths, passes] = [this.scene, shownPaths.peek(), shownPassing.peek()];
    if (!paths) return null;
    const box = stage.renderer.domElement.getBoundingClientRect();
    const [left, top] = [clientX - box.left, clientY - box.top];
    const blocks = this.shown.peek()?.blocks;
    const block = blocks && (!isWhole.peek() || areEndsShown.peek()) ? blockUnder(stage, blocks, passes, left, top) : -1;
    if (block >= 0) return paths.rocks[block]!;
    if (!arePathsShown.peek()) return null;
    return rockNear(stage, paths, passes, this.scene.local(paths.header.origin), left, top, 8);
  }

  private move(now: number, whole: boolean, withPaths: boolean, withEnds: boolean) {
    for (const { value: run } of [this.shown, this.compared]) {
      if (!run) continue;
      run.lines.object.visible = withPaths;
      run.look.uniforms.time.value = whole ? Infinity : now;
      run.look.uniforms.isWhole.value = whole;
      // When all rocks have stopped, they are drawn at their end points.
      run.dots.object.visible = !whole || withEnds;
      run.dots.at(whole ? Infinity : now);
      run.blocks?.at(whole ? Infinity : now, run.dots.values);
    }
    this.scene.stage.invalidate();
  }

  /// Shows the block of the selected rock in its colour; without end points, of all blocks at rest only this one.
  private chooseBlock(rock: number | null, isOnly: boolean) {
    const accent = colourOf(cssColour('--accent')).map((part) => part / 255);
    const [shown, compared] = [this.shown.value, this.compared.value];
    shown?.blocks?.choose(rock === null ? -1 : indexOfRock(shown.paths, rock), accent, isOnly);
    compared?.blocks?.choose(-1, accent, isOnly);
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
    const { stage } = this.scene;
    const { width, height } = stage.size;
    const ratio = stage.renderer.getPixelRatio();
    const { tolerance, segments } = stage.detail;
    const perMetre = height / (2 * Math.tan((stage.camera.fov * Math.PI) / 360));
    const stretch = stage.world.scale.z;
    this.eye.copy(stage.camera.position);
    this.eye.z /= stretch;
    // In pixels of a fine screen or print; and an error is drawn as much larger as heights are exaggerated.
    const allowed = tolerance / Math.max(1, ratio) / Math.max(1, stretch);
    this.measureOf(this.shown.peek(), width, height, ratio, perMetre, allowed, segments);
    this.measureOf(this.compared.peek(), width, height, ratio, perMetre, allowed, segments);
  }

  private measureOf(run: RunPaths | null, width: number, height: number, ratio: number, perMetre: number, tolerance: number, most: number) {
    if (!run) return;
    const { uniforms } = run.look;
    uniforms.pixels.value[0] = width;
    uniforms.pixels.value[1] = height;
    uniforms.ratio.value = ratio;
    run.blocks?.select(this.scene.stage);
    if (run.lines.object.visible) run.lines.choose(this.scene.stage.isMoving, this.eye, perMetre, tolerance, most);
  }

  dispose() {
    this.ends.forEach((end) => end());
    clear(this.chosen);
  }
}
