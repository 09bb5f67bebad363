// Trajectories on a separate canvas. It is redrawn only when the view or the colours change, a few milliseconds at a time,
// so that ten thousand trajectories do not block the page.

import { runColour } from '../view/theme';
import type { Colouring } from '../paths/colouring';
import { colourNumbers } from '../paths/rockColours';
import type { DrawnPaths } from '../paths/drawnPaths';
import { nearestRock } from '../paths/nearestRock';
import { pixelOf, type Frame } from './frame';

export interface ComparedToDraw {
  paths: DrawnPaths;
  passes: Uint8Array | null; // for each rock; null: all
}
export interface PathsToDraw extends ComparedToDraw {
  colouring: Colouring;
}

const budget = 10; // ms at a time

type Pen = CanvasRenderingContext2D;

export function drawPath(pen: Pen, frame: Frame, paths: DrawnPaths, rock: number, colour: (point: number) => string) {
  const [first, end] = [paths.starts[rock]!, paths.starts[rock + 1]!];
  const { origin } = paths.header;
  const at = (k: number) => pixelOf(frame, origin[0] + paths.positions[3 * k]!, origin[2] + paths.positions[3 * k + 2]!);
  let now = '';
  for (let k = first + 1; k < end; ++k) {
    const next = colour(k);
    if (next !== now) {
      if (now) pen.stroke();
      pen.beginPath();
      pen.moveTo(...at(k - 1));
      pen.strokeStyle = now = next;
    }
    pen.lineTo(...at(k));
  }
  if (now) pen.stroke();
}

/// Draws one trajectory per call; false when there are no more.
type Task = () => boolean;

function coloured(pen: Pen, frame: Frame, { paths, colouring, passes }: PathsToDraw): Task {
  const { of, css } = colourNumbers(colouring);
  let rock = 0;
  return () => {
    if (rock >= paths.rocks.length) return false;
    pen.lineWidth = paths.rocks.length > 500 ? 0.8 : 1.4;
    if (!passes || passes[rock]) drawPath(pen, frame, paths, rock, (point) => css[of(point, rock)]!);
    return ++rock < paths.rocks.length;
  };
}

function compared(pen: Pen, frame: Frame, { paths, passes }: ComparedToDraw): Task {
  const colour = runColour('compared');
  let rock = 0;
  return () => {
    if (rock >= paths.rocks.length) return false;
    pen.lineWidth = 1;
    if (!passes || passes[rock]) drawPath(pen, frame, paths, rock, () => colour);
    return ++rock < paths.rocks.length;
  };
}

function pathTasks(pen: Pen, frame: Frame, shown: PathsToDraw | null, other: ComparedToDraw | null): Task[] {
  return [...(other ? [compared(pen, frame, other)] : []), ...(shown ? [coloured(pen, frame, shown)] : [])];
}

/// Draws all trajectories at once, for print.
export function drawPaths(pen: Pen, frame: Frame, shown: PathsToDraw | null, other: ComparedToDraw | null) {
  pen.lineJoin = 'round';
  for (const task of pathTasks(pen, frame, shown, other)) while (task());
}

export class PathLayer {
  readonly canvas = document.createElement('canvas');
  private waiting = 0;

  /// `progress` is called whenever more is drawn.
  constructor(private readonly progress: () => void) {}

  draw(frame: Frame, shown: PathsToDraw | null, other: ComparedToDraw | null) {
    this.stop();
    const scale = Math.min(devicePixelRatio, 2);
    Object.assign(this.canvas, { width: Math.round(frame.width * scale), height: Math.round(frame.height * scale) });
    const pen = this.canvas.getContext('2d');
    if (!pen) return;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.lineJoin = 'round';
    const tasks = pathTasks(pen, frame, shown, other);
    const go = () => {
      const until = performance.now() + budget;
      while (tasks[0] && performance.now() < until) if (!tasks[0]()) tasks.shift();
      this.progress();
      this.waiting = tasks.length > 0 ? requestAnimationFrame(go) : 0;
    };
    go();
  }

  stop() {
    cancelAnimationFrame(this.waiting);
  }
}

/// The rock with the trajectory nearest to a pixel; null if none is within `within` pixels.
export function rockAt({ paths, passes }: PathsToDraw, frame: Frame, left: number, top: number, within: number): number | null {
  const { header, positions } = paths;
  const at = (k: number) => pixelOf(frame, header.origin[0] + positions[3 * k]!, header.origin[2] + positions[3 * k + 2]!);
  return nearestRock(paths, passes, at, [left, top], within);
}
