// The picture of the section: what of it is seen, and everything that is drawn, again whenever something changes.

import { computed, effect, signal, untracked } from '@preact/signals';
import { model } from '../state/model';
import { chosen, chosenRock } from '../state/view';
import { colouring } from '../paths/colouring';
import { comparedPaths, shownPaths } from '../paths/drawnPaths';
import { isWhole, time } from '../paths/playback';
import { RocksAtTime } from '../paths/rocksAtTime';
import { comparedPassing, shownPassing } from '../paths/shownPassing';
import { overlays } from '../scene/tool';
import { equalAxes, layers } from '../view/settings';
import { cssColour, shade } from '../view/theme';
import { drawAxes, drawGrid, drawSlope, type Look } from './drawGround';
import { drawBarriers, drawOverlays, drawSeeders } from './drawMarks';
import { drawChosen, drawEnds, drawMovingRocks } from './drawRocks';
import { fitted, type Bounds, type Frame } from './frame';
import { PathLayer, type PathsToDraw } from './pathLayer';
import { profile } from './profile';

/// Null until the picture has a size and something to show.
export const frame = signal<Frame | null>(null);
export const pointer = signal<{ x: number; z: number; ground: number | null } | null>(null);

/// The slope, and what stands on it.
const bounds = computed<Bounds | null>(() => {
  const places = (profile.value?.vertices ?? []).map(([x, z]) => ({ x, z }));
  const now = model.value;
  if (places.length === 0 || !now) return null;
  for (const [x, , z] of [...now.seeders.flatMap(({ points }) => points), ...now.barriers.flatMap(({ top }) => top)])
    places.push({ x, z });
  const range = (values: number[]): [number, number] => [Math.min(...values), Math.max(...values)];
  return { x: range(places.map(({ x }) => x)), z: range(places.map(({ z }) => z)) };
});

export function fit() {
  if (!frame.value || !bounds.value) return;
  frame.value = fitted(bounds.value, frame.value.width, frame.value.height, equalAxes.value);
}

const look = (): Look => ({
  text: cssColour('--text'),
  faint: cssColour('--faint'),
  line: cssColour('--line'),
  panel: cssColour('--panel'),
  ground: cssColour('--sunken'),
  accent: cssColour('--accent'),
});

const rocksToDraw = computed<PathsToDraw | null>(() =>
  shownPaths.value && colouring.value
    ? { paths: shownPaths.value, colouring: colouring.value, passes: shownPassing.value }
    : null,
);
/// What is seen of the runs' paths.
export const pathsToDraw = computed(() => (layers.paths.value ? rocksToDraw.value : null));
const comparedToDraw = computed(() =>
  layers.paths.value && comparedPaths.value ? { paths: comparedPaths.value, passes: comparedPassing.value } : null,
);
const moving = computed(() => (shownPaths.value ? new RocksAtTime(shownPaths.value) : null));

function drawRun(pen: CanvasRenderingContext2D, now: Frame, paths: HTMLCanvasElement, colours: Look) {
  // Rocks in motion stand out before their paths.
  pen.globalAlpha = isWhole.value ? 1 : 0.3;
  if (layers.paths.value && paths.width > 0) pen.drawImage(paths, 0, 0, now.width, now.height);
  pen.globalAlpha = 1;
  const seen = rocksToDraw.value;
  if (!seen) return;
  if (chosenRock.value !== null) drawChosen(pen, now, seen.paths, chosenRock.value, colours);
  if (isWhole.value) {
    if (layers.ends.value) drawEnds(pen, now, seen.paths, seen.passes, colours);
  } else if (moving.value) drawMovingRocks(pen, now, seen.paths, moving.value, time.value, seen.passes, colours);
}

function draw(canvas: HTMLCanvasElement, now: Frame, paths: HTMLCanvasElement) {
  const scale = Math.min(devicePixelRatio, 2);
  const pen = canvas.getContext('2d');
  if (!pen) return;
  const size = { width: Math.round(now.width * scale), height: Math.round(now.height * scale) };
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.clearRect(0, 0, now.width, now.height);
  const colours = look();
  const path = chosen.value?.join('.') ?? '';
  drawGrid(pen, now, colours);
  if (profile.value && layers.terrain.value) drawSlope(pen, now, profile.value, colours);
  drawRun(pen, now, paths, colours);
  if (model.value && layers.barriers.value) drawBarriers(pen, now, model.value, colours, path);
  if (model.value && layers.seeders.value) drawSeeders(pen, now, model.value, colours, path);
  drawOverlays(pen, now, Object.values(overlays.value).flat(), colours);
  drawAxes(pen, now, colours);
}

/// Keeps a canvas as large as its host and up to date; ends when called.
export function keepDrawn(host: HTMLElement, canvas: HTMLCanvasElement): () => void {
  const watch = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    if (frame.value) frame.value = { ...frame.value, width, height };
    else frame.value = { width, height, x: 0, z: 0, along: 1, up: 1 };
  });
  watch.observe(host);

  // What is new is shown whole; later changes leave the view where the user has it, unless they outgrow it.
  let shown = '';
  const stopFitting = effect(() => {
    const [now, all] = [frame.value, bounds.value];
    void equalAxes.value;
    const state = `${model.value?.project.name ?? ''} ${all?.x} ${all?.z} ${equalAxes.value} ${now?.width} ${now?.height}`;
    if (!now || !all || state === shown) return;
    shown = state;
    fit();
  });
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
    void [rocksToDraw.value, time.value, isWhole.value];
    if (!now) return;
    cancelAnimationFrame(waiting);
    waiting = requestAnimationFrame(() => draw(canvas, now, layer.canvas));
  });
  return () => {
    watch.disconnect();
    stopFitting();
    stopPaths();
    layer.stop();
    stopDrawing();
    cancelAnimationFrame(waiting);
    frame.value = null;
  };
}
