// Draws rocks over the trajectories: moving rocks, end points, the selected rock.

import { indexOfRock, type DrawnPaths } from '../paths/drawnPaths';
import { drawnRadius, leastRadius } from '../paths/rockSize';
import type { RocksAtTime } from '../paths/rocksAtTime';
import { pixelOf, type Frame } from './frame';
import type { Look } from './drawGround';
import { colourOf, isDark } from '../view/colours';
import { drawPath, rockColours, type PathsToDraw } from './pathLayer';

type Pen = CanvasRenderingContext2D;

/// `places` has three coordinates per rock; `pointOf` returns the point of the trajectory that sets its colour, or null.
function discs(pen: Pen, frame: Frame, seen: PathsToDraw, places: Float32Array, pointOf: (rock: number) => number | null) {
  const { paths, passes, colouring } = seen;
  const colourOfRock = rockColours(colouring);
  const least = leastRadius(paths.rocks.length);
  const largest = paths.radii.reduce((most, radius) => Math.max(most, radius), 0);
  const scale = Math.sqrt(frame.along * frame.up);
  pen.lineWidth = 0.9;
  for (let k = 0; 3 * k < places.length; ++k) {
    if (passes && !passes[k]) continue;
    const [x, y] = pixelOf(frame, places[3 * k]!, places[3 * k + 2]!);
    const fill = colourOfRock(pointOf(k), k);
    pen.fillStyle = fill;
    pen.strokeStyle = rimOf(fill);
    pen.beginPath();
    pen.arc(x, y, drawnRadius(paths.radii[k]!, largest, scale, least), 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }
}

const rims = new Map<string, string>();
/// The colour of an outline that contrasts with a CSS colour.
function rimOf(fill: string): string {
  const known = rims.get(fill);
  if (known) return known;
  const parts = fill.startsWith('#') ? colourOf(fill) : (fill.match(/\d+/g)!.map(Number) as [number, number, number]);
  const rim = isDark(parts) ? '#ffffff' : '#2a2620';
  rims.set(fill, rim);
  return rim;
}

export function drawMovingRocks(pen: Pen, frame: Frame, seen: PathsToDraw, rocks: RocksAtTime, time: number) {
  const { paths } = seen;
  const places = new Float32Array(3 * paths.rocks.length);
  rocks.find(time);
  rocks.read(paths.positions, 3, places, paths.header.origin);
  discs(pen, frame, seen, places, (k) => rocks.after[k]!);
}

export function drawEnds(pen: Pen, frame: Frame, seen: PathsToDraw) {
  const { paths } = seen;
  const places = new Float32Array(3 * paths.rocks.length);
  for (let k = 0; k < paths.rocks.length; ++k) {
    const last = paths.starts[k + 1]! - 1;
    for (let axis = 0; axis < 3; ++axis) places[3 * k + axis] = paths.header.origin[axis]! + paths.positions[3 * last + axis]!;
  }
  discs(pen, frame, seen, places, () => null);
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
