// Draws rocks over the trajectories: moving rocks, end points, the selected rock.

import { indexOfRock, type DrawnPaths } from '../paths/drawnPaths';
import { drawnRadius, leastRadius } from '../paths/rockSize';
import type { RocksAtTime } from '../paths/rocksAtTime';
import { pixelOf, type Frame } from './frame';
import type { Look } from './drawGround';
import type { SectionBlocks } from './sectionBlocks';
import { colourOf, isDark } from '../view/colours';
import { drawPath, type PathsToDraw } from './pathLayer';
import { rockColours } from '../paths/rockColours';

type Pen = CanvasRenderingContext2D;

/// What is drawn of the rocks of a run.
export interface RocksToDraw {
  seen: PathsToDraw;
  blocks: SectionBlocks | null;
  /// The selected rock, by its index; -1: none. Its block has the accent colour.
  chosen: number;
  /// Whether no other is drawn, and this one only as a block.
  isChosenOnly: boolean;
}

/// `places` has three coordinates per rock; `pointOf` returns the point of the trajectory that sets its colour, or null.
/// A rock with a shape is a block once it is larger than the smallest disc.
function draw(pen: Pen, frame: Frame, rocks: RocksToDraw, places: Float32Array, pointOf: (rock: number) => number | null, look: Look) {
  const { paths, passes, colouring } = rocks.seen;
  const colourOfRock = rockColours(colouring);
  const least = leastRadius(paths.rocks.length);
  const largest = paths.radii.reduce((most, radius) => Math.max(most, radius), 0);
  const scale = Math.sqrt(frame.along * frame.up);
  pen.lineWidth = 0.9;
  const drawRock = (k: number) => {
    if (passes && !passes[k]) return;
    const radius = drawnRadius(paths.radii[k]!, largest, scale, least);
    const block = radius > paths.radii[k]! * scale ? null : (rocks.blocks?.outlineOf(k) ?? null);
    const isChosen = k === rocks.chosen && block !== null;
    if (rocks.isChosenOnly && !isChosen) return;
    const fill = isChosen ? look.accent : colourOfRock(pointOf(k), k);
    pen.fillStyle = fill;
    pen.strokeStyle = rimOf(fill);
    pen.beginPath();
    if (block) {
      for (const [x, z] of block) pen.lineTo(...pixelOf(frame, x, z));
      pen.closePath();
    } else {
      const [x, y] = pixelOf(frame, places[3 * k]!, places[3 * k + 2]!);
      pen.arc(x, y, radius, 0, 2 * Math.PI);
    }
    pen.fill();
    pen.stroke();
  };
  for (let k = 0; 3 * k < places.length; ++k) if (k !== rocks.chosen) drawRock(k);
  if (rocks.chosen >= 0) drawRock(rocks.chosen); // over the others
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

export function drawMovingRocks(pen: Pen, frame: Frame, rocks: RocksToDraw, moving: RocksAtTime, time: number, look: Look) {
  const { paths } = rocks.seen;
  const places = new Float32Array(3 * paths.rocks.length);
  moving.find(time);
  moving.read(paths.positions, 3, places, paths.header.origin);
  rocks.blocks?.at.find(time);
  draw(pen, frame, rocks, places, (k) => moving.after[k]!, look);
}

export function drawEnds(pen: Pen, frame: Frame, rocks: RocksToDraw, look: Look) {
  const { paths } = rocks.seen;
  const places = new Float32Array(3 * paths.rocks.length);
  for (let k = 0; k < paths.rocks.length; ++k) {
    const last = paths.starts[k + 1]! - 1;
    for (let axis = 0; axis < 3; ++axis) places[3 * k + axis] = paths.header.origin[axis]! + paths.positions[3 * last + axis]!;
  }
  rocks.blocks?.at.find(Infinity);
  draw(pen, frame, rocks, places, () => null, look);
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
