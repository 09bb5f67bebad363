import { expect, test } from 'vitest';
import { alongLine, bestBox, heightOf, widthOf, type Box } from './framing';
import type { Pixel } from './nearness';

const room: Box = { left: 0, top: 0, right: 1000, bottom: 400 };
const toolbar: Box = { left: 0, top: 0, right: 700, bottom: 50 };
const legend: Box = { left: 800, top: 0, right: 1000, bottom: 180 };

/// Places a rectangle with this ratio of width to height in the centre of a box.
const panel = (aspect: number) => (box: Box) => {
  const height = Math.min(heightOf(box), widthOf(box) / aspect);
  const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
  const [a, b] = [(aspect * height) / 2, height / 2];
  const rows = Array.from({ length: 51 }, (_, k): [Pixel, Pixel] => [
    [x - a, y - b + (k / 50) * height],
    [x + a, y - b + (k / 50) * height],
  ]);
  return { size: height, points: rows.flatMap((row) => [...alongLine(row)]) };
};

test('content that fills its box avoids the covered parts', () => {
  const { size, points } = bestBox(room, [toolbar, legend], panel(2))!;
  expect(size).toBe(350);
  for (const [, y] of points) expect(y).toBeGreaterThanOrEqual(50);
});
test('content with a free corner may have a legend there', () => {
  // A slope that falls from the upper left to the lower right.
  const slope = (box: Box) => ({
    size: Math.min(widthOf(box) / 2, heightOf(box)),
    points: alongLine([[box.left, box.top], [box.left + 0.3 * widthOf(box), box.bottom - 30], [box.right, box.bottom]]),
  });
  expect(bestBox(room, [legend], slope)!.size).toBe(400);
});
test('boxes outside the picture have no effect', () => {
  expect(bestBox(room, [], panel(2))!.size).toBe(400);
  expect(bestBox(room, [{ left: 0, top: 500, right: 1000, bottom: 600 }], panel(2))!.size).toBe(400);
});
test('a fully covered picture still shows the content', () => {
  expect(bestBox(room, [{ left: -1, top: -1, right: 1001, bottom: 401 }], panel(2))!.size).toBe(400);
});
test('points along a line are at most `step` pixels apart', () => {
  const places = [...alongLine([[0, 0], [100, 0], [100, 3]], 8)];
  expect(places).toContainEqual([100, 3]);
  places.slice(1).forEach(([x, y], k) => expect(Math.hypot(x - places[k]![0], y - places[k]![1])).toBeLessThanOrEqual(8));
});
