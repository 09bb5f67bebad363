// Drawing what is asked in the views, and dragging it there.

import type { Point2, Point3 } from '../api/types';
import { draw } from '../tools/drawing';
import { dimension } from '../project/place';
import { pathOf } from '../settings/names';
import { rounded } from '../geometry/plan';
import { grips, tool, useTool, type GripDrag } from '../tools/tool';
import { valueAt } from '../project/document';
import { model } from '../project/model';
import { distanceToLine, type Pixel } from '../geometry/nearness';
import { answer, ask, asked, draggedPoints, isAsking, openCard, setDraggedPoints } from './asked';
import { onGround } from './foot';
import { moved, type Asked } from './shape';

const names = { line: 'Ask a line', polygon: 'Ask an area' } as const;
export const isDrawing = (kind: 'line' | 'polygon') => tool.value?.name === names[kind];

const extent = () => {
  const bounds = model.peek()?.bounds;
  return bounds ? Math.max(bounds.max[0] - bounds.min[0], bounds.max[1] - bounds.min[1]) : 0;
};
const onPlan = ([x, y]: readonly number[]): Point2 => [rounded(x!, extent()), rounded(y!, extent())];

export function drawAsked(kind: 'line' | 'polygon') {
  openCard();
  if (isDrawing(kind)) return useTool(null);
  if (dimension.peek() === 2)
    draw({
      name: names.line,
      kind: 'points',
      least: 1,
      most: 1,
      hint: 'Click the place that is asked.',
      done: ([place]) => ask({ kind: 'line', points: [[onPlan(place!)[0], 0]] }, 'ask a place'),
    });
  else
    draw({
      name: names[kind],
      kind,
      least: kind === 'line' ? 2 : 3,
      hint: kind === 'line' ? 'Click along the line that is asked.' : 'Click around the area that is asked.',
      done: (places) => ask({ kind, points: places.map(onPlan) }, kind === 'line' ? 'ask a line' : 'ask an area'),
    });
}

/// The line of a barrier in the project; in 2D its place.
export function lineOfBarrier(name: string): Point2[] {
  const path = model.value?.barriers.find((each) => each.name === name)?.path;
  const line = path === undefined ? undefined : valueAt([...pathOf(path), 'line']);
  if (typeof line === 'number') return [[line, 0]];
  return Array.isArray(line) ? line.flatMap((point): Point2[] => (Array.isArray(point) ? [[Number(point[0]), Number(point[1])]] : [])) : [];
}

/// The points on plan of what is asked.
export const pointsOf = (now: Asked): Point2[] => (now.kind === 'barrier' ? lineOfBarrier(now.name) : now.points);

/// The draped line of the answer, or the outline of the area.
export function groundOf(): Point3[] {
  const found = answer.value;
  if (!found) return [];
  return found.kind !== 'polygon' ? found.foot : found.outline.flatMap(([x, y, z]): Point3[] => (z === null ? [] : [[x, y, z]]));
}

/// The points at their elevations.
export function cornersOf(now: Asked): Point3[] {
  const { min, max } = model.value?.bounds ?? { min: [0, 0, 0], max: [0, 0, 0] };
  return onGround(pointsOf(now), groundOf(), (min[2]! + max[2]!) / 2);
}

const nearVertex = 10; // pixels
const nearLine = 7;

/// The drag of a corner, or of the whole.
function dragOf(now: Asked, corners: readonly Point3[], corner: number | null, from: Point2 | null): GripDrag {
  const first = corners.map(([x, y]): Point2 => [x, y]);
  let begun = from;
  const is2d = dimension.peek() === 2;
  return {
    move([x, y]) {
      begun ??= [x, y];
      const [dx, dy] = [x - begun[0], y - begun[1]];
      const next = corner === null ? moved(first, dx, dy) : first.with(corner, [x, y]);
      setDraggedPoints(next.map(([px, py]) => (is2d ? [onPlan([px, 0])[0], 0] : onPlan([px, py]))));
    },
    drop() {
      const points = draggedPoints.value;
      setDraggedPoints(null);
      if (points) ask({ kind: now.kind === 'polygon' ? 'polygon' : 'line', points }, `move the asked ${now.kind === 'polygon' ? 'area' : 'line'}`);
    },
    cancel() {
      setDraggedPoints(null);
    },
  };
}

grips.add((pixelOf, at) => {
  const now = asked.peek();
  if (!isAsking.peek() || !now) return null;
  const corners = cornersOf(now);
  const pixels = corners.map(pixelOf);
  const away = (pixel: Pixel | null) => (pixel ? Math.hypot(pixel[0] - at[0], pixel[1] - at[1]) : Infinity);
  const nearest = pixels.reduce((best, pixel, k) => (away(pixel) < away(pixels[best]!) ? k : best), 0);
  if (pixels.length > 0 && away(pixels[nearest]!) <= nearVertex) return dragOf(now, corners, nearest, null);
  // The line as it is drawn: over the ground between its corners.
  const drawn = [...(now.kind === 'polygon' ? [...corners, ...corners.slice(0, 1)] : corners)].map(pixelOf);
  const ground = groundOf().map(pixelOf);
  const isOn = (line: (Pixel | null)[]) =>
    line.some((pixel, k) => k > 0 && pixel && line[k - 1] && distanceToLine(at, line[k - 1]!, pixel) <= nearLine);
  return isOn(drawn) || isOn(ground) ? dragOf(now, corners, null, null) : null;
});
