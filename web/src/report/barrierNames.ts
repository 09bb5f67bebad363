// Barriers and collectors on a map, with their names.

import type { Settings } from '../archive/summary';
import type { Group } from '../figures/plot';
import type { MapFrame } from './mapRoom';
import { barrierLine, nameIn } from './run';
import { boxOfText, isFree, type Anchor, type Box } from './textBoxes';
import type { Point } from './travel';

// A point of a line, at a share of its length.
function alongLine(line: readonly Point[], share: number): Point[] {
  const parts = line.slice(1).map(([x, y], k) => {
    const [x0, y0] = line[k]!;
    return { x0, y0, dx: x - x0, dy: y - y0, length: Math.hypot(x - x0, y - y0) };
  });
  let rest = share * parts.reduce((sum, { length }) => sum + length, 0);
  for (const [k, { x0, y0, dx, dy, length }] of parts.entries()) {
    if (rest > length && k + 1 < parts.length) {
      rest -= length;
      continue;
    }
    const t = length > 0 ? rest / length : 0;
    return [[x0 + t * dx, y0 + t * dy]];
  }
  return [];
}

interface NamePlace {
  anchor: Anchor;
  x: number;
  y: number;
  box: Box;
}

// Where the name of a line can stand: beside its last point, its first or a point between, and then above or below.
function namePlaces(name: string, line: readonly Point[], { side, toX, toY }: MapFrame): NamePlace[] {
  const points = [...line.slice(-1), ...line.slice(0, 1), ...[0.85, 0.15, 0.5].flatMap((share) => alongLine(line, share))];
  const beside = (anchor: Anchor, dx: number, dy: number) =>
    points.map((point): NamePlace => {
      const [x, y] = [toX(point[0]) + dx, Math.max(toY(point[1]) + dy, side.top + 14)];
      return { anchor, x, y, box: boxOfText(name, anchor, x, y) };
    });
  return [...beside('start', 8, 4), ...beside('end', -8, 4), ...beside('middle', 0, -8), ...beside('middle', 0, 18)];
}

/// The names keep clear of the boxes in `taken`, to which theirs are added.
export function drawBarriersOnPlan(group: Group, barriers: readonly Settings[], frame: MapFrame, taken: Box[]) {
  const { left, top, right, bottom } = frame.side;
  const lines = barriers
    .map((barrier) => ({ name: nameIn(barrier), line: barrierLine(barrier) }))
    .filter(({ line }) => line.length > 1);
  for (const { line } of lines) {
    const corners = line.map(([x, y]) => `${frame.toX(x)},${frame.toY(y)}`);
    group.append('path').attr('class', 'barrier').attr('d', `M${corners.join('L')}`);
  }
  for (const { name, line } of lines) {
    const places = namePlaces(name, line, frame);
    const inside = places.filter(({ box }) => box[0] >= left && box[2] <= right && box[1] >= top && box[3] <= bottom);
    const place = inside.find(({ box }) => isFree(box, taken)) ?? inside[0] ?? places[0];
    if (!place) continue;
    taken.push(place.box);
    const text = group.append('text').attr('class', 'barrier-name halo').attr('text-anchor', place.anchor).text(name);
    text.attr('x', place.x).attr('y', place.y);
  }
}
