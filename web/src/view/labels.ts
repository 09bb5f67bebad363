// Places names in a view without overlaps.

import { overlap, type Box } from '../geometry/framing';
import type { Pixel } from '../geometry/nearness';

/// A name with its size, its point, and the radius of the point's mark (`reach`).
export interface Label {
  text: string;
  width: number;
  height: number;
  at: Pixel;
  reach: number;
  /// The colour of a plate behind it, with white text.
  plate?: string;
}

export interface PlacedLabel extends Label {
  box: Box;
  /// Whether it is so far away that a line connects it to its point.
  isDetached: boolean;
}

const gap = 3; // pixels between a mark and its name
const directions: readonly (readonly [number, number])[] = [
  [0, -1],
  [1, 0],
  [-1, 0],
  [0, 1],
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
];
const distances = [0, 14, 30, 50, 76];

function boxAt({ width, height, at: [x, y], reach }: Label, [right, down]: readonly [number, number], away: number): Box {
  const off = reach + gap + away;
  const left = x - width / 2 + right * (off + width / 2);
  const top = y - height / 2 + down * (off + height / 2);
  return { left, top, right: left + width, bottom: top + height };
}

const isWithin = (box: Box, room: Box) =>
  box.left >= room.left && box.right <= room.right && box.top >= room.top && box.bottom <= room.bottom;

/// Places each name near its point, the first ones first: above, beside, below, then farther away. Names do not overlap
/// marks. A name is omitted if there is no space, or if its point is outside the room.
export function placeLabels(labels: readonly Label[], room: Box, over: readonly Box[]): PlacedLabel[] {
  const inRoom = labels.filter(({ at: [x, y] }) => x >= room.left && x <= room.right && y >= room.top && y <= room.bottom);
  const marks = inRoom.map(({ at: [x, y], reach: r }): Box => ({ left: x - r, top: y - r, right: x + r, bottom: y + r }));
  const placed: PlacedLabel[] = [];
  for (const label of inRoom) {
    const taken = [...over, ...marks, ...placed.map(({ box }) => box)];
    const tries = distances.flatMap((away) => directions.map((direction) => ({ away, box: boxAt(label, direction, away) })));
    const found = tries.find(({ box }) => isWithin(box, room) && !taken.some((other) => overlap(box, other)));
    if (found) placed.push({ ...label, box: found.box, isDetached: found.away > 0 });
  }
  return placed;
}

type Pen = CanvasRenderingContext2D;
const font = '600 12px system-ui, sans-serif';

/// A label with its measured size.
export function labelOf(pen: Pen, text: string, at: Pixel, reach: number, plate?: string): Label {
  pen.font = font;
  const limit = 40; // characters
  const short = text.length > limit ? `${text.slice(0, limit - 1)}…` : text;
  const width = pen.measureText(short).width + 4;
  return plate === undefined ? { text: short, width, height: 15, at, reach } : { text: short, width: width + 8, height: 20, at, reach, plate };
}

export function drawLabels(pen: Pen, labels: readonly PlacedLabel[], colours: { text: string; halo: string }) {
  pen.font = font;
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  pen.lineJoin = 'round';
  for (const { text, at: [x, y], box, isDetached, plate } of labels) {
    const [left, middle] = [box.left + (plate === undefined ? 2 : 6), (box.top + box.bottom) / 2];
    if (isDetached) {
      const [toX, toY] = [Math.max(box.left, Math.min(box.right, x)), Math.max(box.top, Math.min(box.bottom, y))];
      for (const [width, colour] of [[plate === undefined ? 3 : 4, plate === undefined ? colours.halo : '#ffffff'], [plate === undefined ? 1 : 2, plate ?? colours.text]] as const) {
        pen.lineWidth = width;
        pen.strokeStyle = colour;
        pen.beginPath();
        pen.moveTo(x, y);
        pen.lineTo(toX, toY);
        pen.stroke();
      }
    }
    if (plate === undefined) {
      pen.lineWidth = 3.5;
      pen.strokeStyle = colours.halo;
      pen.strokeText(text, left, middle);
    } else {
      pen.beginPath();
      pen.roundRect(box.left, box.top, box.right - box.left, box.bottom - box.top, 4);
      pen.lineWidth = 3;
      pen.strokeStyle = '#ffffff';
      pen.stroke();
      pen.fillStyle = plate;
      pen.fill();
    }
    pen.fillStyle = plate === undefined ? colours.text : '#ffffff';
    pen.fillText(text, left, middle);
  }
}
