// Single rocks over the paths: where they are at the moment that is shown, where they ended, the one that is chosen.

import { indexOfRock, type DrawnPaths } from '../paths/drawnPaths';
import type { RocksAtTime } from '../paths/rocksAtTime';
import { pixelOf, type Frame } from './frame';
import type { Look } from './drawGround';
import { drawPath } from './pathLayer';

type Pen = CanvasRenderingContext2D;

function discs(pen: Pen, places: Float32Array, passes: Uint8Array | null, frame: Frame, size: number, fill: string, rim: string) {
  pen.fillStyle = fill;
  pen.strokeStyle = rim;
  pen.lineWidth = 1;
  for (let k = 0; 3 * k < places.length; ++k) {
    if (passes && !passes[k]) continue;
    const [x, y] = pixelOf(frame, places[3 * k]!, places[3 * k + 2]!);
    pen.beginPath();
    pen.arc(x, y, size, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }
}

export function drawMovingRocks(pen: Pen, frame: Frame, paths: DrawnPaths, rocks: RocksAtTime, time: number, passes: Uint8Array | null, look: Look) {
  const places = new Float32Array(3 * paths.rocks.length);
  rocks.find(time);
  rocks.read(paths.positions, 3, places, paths.header.origin);
  discs(pen, places, passes, frame, 4, look.text, look.panel);
}

export function drawEnds(pen: Pen, frame: Frame, paths: DrawnPaths, passes: Uint8Array | null, look: Look) {
  const places = new Float32Array(3 * paths.rocks.length);
  for (let k = 0; k < paths.rocks.length; ++k) {
    const last = paths.starts[k + 1]! - 1;
    for (let axis = 0; axis < 3; ++axis) places[3 * k + axis] = paths.header.origin[axis]! + paths.positions[3 * last + axis]!;
  }
  discs(pen, places, passes, frame, 3, look.text, look.panel);
}

export function drawChosen(pen: Pen, frame: Frame, paths: DrawnPaths, rock: number, look: Look) {
  const k = indexOfRock(paths, rock);
  if (k < 0) return;
  for (const [width, colour] of [
    [6, look.panel],
    [3, look.text],
  ] as const) {
    pen.lineWidth = width;
    pen.lineJoin = 'round';
    drawPath(pen, frame, paths, k, () => colour);
  }
}
