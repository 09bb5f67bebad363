// Shows the shape of the open tool over the section, dashed, with handles to drag.

import { effect } from '@preact/signals';
import type { Point2, Point3 } from '../api/types';
import { showDragHint } from '../drag/drag';
import { onGrid } from '../drag/snapping';
import { grips, showOverlay, type GripDrag, type Overlay } from '../tools/tool';
import { groundBelow, profile } from '../project/profile';
import { markColours } from '../view/colours';
import { roundStep } from '../geometry/ticks';
import { kind, numbers, possible, problem, setNumbers, setStretch, slopePane, stretch, vertices } from './state';

const in3d = ([x, z]: Point2): Point3 => [x, 0, z];
const onGround = (x: number): Point2[] => {
  const found = profile.value && groundBelow(profile.value, x);
  return found ? [[x, found.z]] : [];
};

interface Mark {
  title: string;
  at: Point2;
  /// Takes a place; returns how to take it back.
  move: (to: Point2) => void;
  back: () => void;
}
/// The handles of the tool, or the ends of the stretch that is asked.
function marks(): Mark[] {
  if (slopePane.value === 'stays') {
    const ends = stretch.value;
    return ['Toe', 'Far edge'].flatMap((title, k) =>
      onGround(ends[k]!).map((at) => ({
        title,
        at,
        move: ([x]: Point2) => setStretch(k === 0 ? [x, ends[1]] : [ends[0], x]),
        back: () => setStretch(ends),
      })),
    );
  }
  const first = numbers.value;
  return (possible.value?.handles ?? []).map(({ title, at, moved }) => ({
    title,
    at,
    move: (to) => setNumbers(moved(to)),
    back: () => setNumbers(first),
  }));
}

effect(() => {
  const now = kind.value && possible.value;
  const line: Overlay[] = now
    ? [{ points: now.line.map(in3d), kind: 'line', isBare: true, isDashed: true, ...(problem.value !== null && { colour: markColours.worst }) }]
    : slopePane.value === 'stays' && profile.value
      ? [{ points: groundOf(stretch.value), kind: 'line', colour: markColours.asked, isBare: true, width: 5 }]
      : [];
  const points = slopePane.value === null ? [] : marks().map(({ at }) => in3d(at));
  showOverlay('slope tools', [
    ...line,
    ...(points.length > 0 ? [{ points, kind: 'points' as const, ...(slopePane.value === 'stays' && { colour: markColours.asked }) }] : []),
  ]);
});

/// The ground between two places.
function groundOf(ends: readonly number[]): Point3[] {
  const [from, to] = [Math.min(...ends), Math.max(...ends)];
  const between = (profile.value?.vertices ?? []).filter(([x]) => x > from && x < to);
  const list = [...onGround(from), ...between, ...onGround(to)];
  return list.map(in3d);
}

const nearHandle = 10; // pixels

function snapped([x, z]: Point2, { ctrl, alt }: { ctrl: boolean; alt: boolean }, metresPerPixel: number): Point2 {
  if (ctrl && !alt) {
    const [gx, , gz] = onGrid([x, 0, z], roundStep(8 * metresPerPixel));
    return [gx, gz];
  }
  const reach = 8 * metresPerPixel;
  const near = alt ? undefined : vertices().find(([vx, vz]) => Math.abs(vx - x) < reach && Math.abs(vz - z) < reach);
  return near ?? [Number(x.toFixed(2)), Number(z.toFixed(2))];
}

const dragOf = ({ title, move, back }: Mark): GripDrag => ({
  move([x, , z], keys, metresPerPixel) {
    const to = snapped([x, z], keys, metresPerPixel);
    move(to);
    showDragHint(`${title}: x ${to[0].toFixed(2)} z ${to[1].toFixed(2)} m`);
  },
  drop() {
    showDragHint(null);
  },
  cancel() {
    showDragHint(null);
    back();
  },
});

grips.add((pixelOf, at) => {
  if (slopePane.peek() === null) return null;
  let [found, least]: [Mark | null, number] = [null, nearHandle];
  for (const mark of marks()) {
    const pixel = pixelOf(in3d(mark.at));
    const away = pixel ? Math.hypot(pixel[0] - at[0], pixel[1] - at[1]) : Infinity;
    if (away < least) [found, least] = [mark, away];
  }
  return found && dragOf(found);
});
