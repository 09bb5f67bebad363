// Draws the picture of the section whenever something changes.

import { computed, effect, signal, untracked } from '@preact/signals';
import { model } from '../project/model';
import { chosen } from '../project/chosen';
import { chosenRock } from '../runs/chosenRock';
import { colouring } from '../paths/colouring';
import { shownBlocks } from '../paths/drawnBlocks';
import { comparedPaths, indexOfRock, shownPaths } from '../paths/drawnPaths';
import { isWhole, time } from '../paths/playback';
import { RocksAtTime } from '../paths/rocksAtTime';
import { comparedPassing, shownPassing } from '../paths/shownPassing';
import { overlays } from '../tools/tool';
import { layers } from '../view/settings';
import { cssColour, shade } from '../view/theme';
import { drawAxes, drawGrid, drawSlope, type Look } from './drawGround';
import { shownObserved } from '../calibration/observations';
import { drawBarriers, drawObserved, drawOverlays, drawSeeders } from './drawMarks';
import { drawChosen, drawEnds, drawMovingRocks } from './drawRocks';
import type { Box } from '../geometry/framing';
import { drawLabels, placeLabels } from '../view/labels';
import { placeOf, type Frame } from './frame';
import { frame, keepFramed, over, roomOf } from './framed';
import { PathLayer, type PathsToDraw } from './pathLayer';
import { profile } from '../project/profile';
import { SectionBlocks } from './sectionBlocks';
import { owned } from '../state/owned';

export const [pointer, setPointer] = owned(signal<{ x: number; z: number; ground: number | null } | null>(null));

const look = (): Look => ({
  text: cssColour('--text'),
  faint: cssColour('--faint'),
  line: cssColour('--line'),
  panel: cssColour('--panel'),
  ground: cssColour('--sunken'),
  accent: cssColour('--accent'),
});

export const rocksToDraw = computed<PathsToDraw | null>(() =>
  shownPaths.value && colouring.value
    ? { paths: shownPaths.value, colouring: colouring.value, passes: shownPassing.value }
    : null,
);
/// The visible trajectories.
export const pathsToDraw = computed(() => (layers.paths.value ? rocksToDraw.value : null));
export const comparedToDraw = computed(() =>
  layers.paths.value && comparedPaths.value ? { paths: comparedPaths.value, passes: comparedPassing.value } : null,
);
const moving = computed(() => (shownPaths.value ? new RocksAtTime(shownPaths.value) : null));
const blocks = computed(() => (shownBlocks.value ? new SectionBlocks(shownBlocks.value) : null));

/// The rock of the block at a pixel, if blocks are drawn there; null if there is none.
export function blockUnder(now: Frame, left: number, top: number): number | null {
  const [seen, drawn] = [rocksToDraw.value, blocks.value];
  if (!seen || !drawn || (isWhole.value && !layers.ends.value)) return null;
  const rock = drawn.around(...placeOf(now, left, top), seen.passes);
  return rock < 0 ? null : seen.paths.rocks[rock]!;
}

function drawRun(pen: CanvasRenderingContext2D, now: Frame, drawPaths: () => void, colours: Look) {
  // Trajectories are faded behind moving rocks.
  pen.globalAlpha = isWhole.value ? 1 : 0.3;
  drawPaths();
  pen.globalAlpha = 1;
  const seen = rocksToDraw.value;
  if (!seen) return;
  if (chosenRock.value !== null) drawChosen(pen, now, seen.paths, chosenRock.value, colours);
  const rocks = {
    seen,
    blocks: blocks.value,
    chosen: chosenRock.value === null ? -1 : indexOfRock(seen.paths, chosenRock.value),
    isChosenOnly: isWhole.value && !layers.ends.value,
  };
  if (isWhole.value) drawEnds(pen, now, rocks, colours);
  else if (moving.value) drawMovingRocks(pen, now, rocks, moving.value, time.value, colours);
}

/// Draws the whole picture in CSS pixels, without names in the boxes `covered`.
export function paint(pen: CanvasRenderingContext2D, now: Frame, drawPaths: () => void, covered: readonly Box[]) {
  const colours = look();
  const path = chosen.value?.join('.') ?? '';
  drawGrid(pen, now, colours);
  if (profile.value && layers.terrain.value) drawSlope(pen, now, profile.value, colours);
  drawRun(pen, now, drawPaths, colours);
  drawObserved(pen, now, shownObserved.value);
  const ofOverlays = drawOverlays(pen, now, Object.values(overlays.value).flat());
  const ofBarriers = model.value && layers.barriers.value ? drawBarriers(pen, now, model.value, path) : [];
  const names = [
    ...ofOverlays,
    ...ofBarriers.filter(({ text }) => !ofOverlays.some((each) => each.plate !== undefined && each.text === text)),
    ...(model.value && layers.seeders.value ? drawSeeders(pen, now, model.value, path) : []),
  ];
  const numbers = drawAxes(pen, now, colours, covered);
  const placed = placeLabels(names, roomOf(now), [...covered, ...numbers]);
  drawLabels(pen, placed, { text: colours.text, halo: colours.panel });
}

function draw(canvas: HTMLCanvasElement, now: Frame, paths: HTMLCanvasElement) {
  const scale = Math.min(devicePixelRatio, 2);
  const pen = canvas.getContext('2d');
  if (!pen) return;
  const size = { width: Math.round(now.width * scale), height: Math.round(now.height * scale) };
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.clearRect(0, 0, now.width, now.height);
  const drawPaths = () => {
    if (layers.paths.value && paths.width > 0) pen.drawImage(paths, 0, 0, now.width, now.height);
  };
  paint(pen, now, drawPaths, over.value);
}

/// Keeps a canvas as large as its host and up to date. Returns a function that ends this.
export function keepDrawn(host: HTMLElement, canvas: HTMLCanvasElement): () => void {
  const stopFraming = keepFramed(host);
  let waiting = 0;
  const draws = signal(0);
  const layer = new PathLayer(() => (draws.value = draws.peek() + 1));
  const stopPaths = effect(() => {
    const [now, seen, other] = [frame.value, pathsToDraw.value, comparedToDraw.value];
    if (now) untracked(() => layer.draw(now, seen, other));
  });
  const stopDrawing = effect(() => {
    const now = frame.value;
    void [shade.value, profile.value, model.value, chosen.value, chosenRock.value, overlays.value, draws.value];
    void [layers.terrain.value, layers.barriers.value, layers.seeders.value, layers.paths.value, layers.ends.value];
    void [shownObserved.value, rocksToDraw.value, blocks.value, time.value, isWhole.value, over.value];
    if (!now) return;
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(() => draw(canvas, now, layer.canvas));
  });
  return () => {
    stopFraming();
    stopPaths();
    layer.stop();
    stopDrawing();
    cancelAnimationFrame(waiting);
  };
}
