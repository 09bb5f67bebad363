// Places the content of a view as large as possible outside the parts that controls and legends cover.

import type { Pixel } from './nearness';

/// A box in CSS pixels from the upper left corner of the view.
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export const widthOf = ({ left, right }: Box) => right - left;
export const heightOf = ({ top, bottom }: Box) => bottom - top;
export const overlap = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
const contains = ({ left, top, right, bottom }: Box, [x, y]: Pixel) => x > left && x < right && y > top && y < bottom;

/// All boxes between the edges of the room and of the boxes over it.
function boxesIn(room: Box, over: readonly Box[]): Box[] {
  const edges = (low: number, high: number, at: number[]) =>
    [...new Set([low, ...at.filter((edge) => edge > low && edge < high), high])].sort((a, b) => a - b);
  const across = edges(room.left, room.right, over.flatMap(({ left, right }) => [left, right]));
  const down = edges(room.top, room.bottom, over.flatMap(({ top, bottom }) => [top, bottom]));
  const pairs = (list: number[]) => list.flatMap((low, k) => list.slice(k + 1).map((high) => [low, high] as const));
  return pairs(across).flatMap(([left, right]) => pairs(down).map(([top, bottom]) => ({ left, top, right, bottom })));
}

/// Content placed in a box: its size (a length in any unit), and some of its points in the view.
export interface Placed {
  size: number;
  points: Iterable<Pixel>;
}

const middle = ({ left, right }: Box) => (left + right) / 2;
const sideCost = 0.35; // the share of its size that content may lose to be in the centre instead of at the side

/// Places the content in the box within the room in which it is largest, with a preference for the centre, and in which
/// none of its points is covered by `over`. A covered corner is allowed if the content leaves it free. `place` places the
/// content in a box; `sizeIn` is its size there, for the many boxes among which one is chosen.
export function bestBox<T extends Placed>(
  room: Box,
  over: readonly Box[],
  place: (box: Box) => T,
  sizeIn = (box: Box) => place(box).size,
): T | null {
  const boxes = boxesIn(room, over)
    .filter((box) => widthOf(box) >= 20 && heightOf(box) >= 20)
    .map((box) => {
      const aside = Math.abs(middle(box) - middle(room)) / (0.5 * widthOf(room));
      return { box, worth: sizeIn(box) * (1 - sideCost * aside) };
    })
    .sort((a, b) => b.worth - a.worth)
    .map(({ box }) => box);
  const isFree = ({ points }: Placed) => {
    for (const point of points) if (over.some((box) => contains(box, point))) return false;
    return true;
  };
  const free = boxes.find((box) => !over.some((each) => overlap(each, box)) || isFree(place(box)));
  const chosen = free ?? boxes[0];
  return chosen ? place(chosen) : null;
}

/// Points along a polyline, at most `step` pixels apart.
export function* alongLine(points: readonly Pixel[], step = 8): Iterable<Pixel> {
  for (let k = 0; k < points.length; ++k) {
    const [from, to] = [points[Math.max(0, k - 1)]!, points[k]!];
    const parts = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / step));
    for (let part = 1; part <= parts; ++part)
      yield [from[0] + (part / parts) * (to[0] - from[0]), from[1] + (part / parts) * (to[1] - from[1])];
  }
}
