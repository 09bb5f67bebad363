import { expect, test } from 'vitest';
import { overlap, type Box } from '../geometry/framing';
import { placeLabels, type Label } from './labels';

const room: Box = { left: 0, top: 0, right: 600, bottom: 300 };
const label = (text: string, x: number, y: number, reach = 5): Label => ({ text, width: 80, height: 15, at: [x, y], reach });

test('a name is above its point', () => {
  const [placed] = placeLabels([label('Crest', 300, 150)], room, []);
  expect(placed!.box).toEqual({ left: 260, top: 127, right: 340, bottom: 142 });
  expect(placed!.isDetached).toBe(false);
});
test('names of adjacent points do not overlap each other, marks or a legend', () => {
  const legend: Box = { left: 320, top: 60, right: 600, bottom: 140 };
  const labels = Array.from({ length: 9 }, (_, k) => label(`Fence ${k}`, 290 + 12 * (k % 3), 140 + 14 * Math.floor(k / 3)));
  const placed = placeLabels(labels, room, [legend]);
  expect(placed.length).toBeGreaterThanOrEqual(7);
  placed.forEach(({ box }, k) => {
    expect(overlap(box, legend)).toBe(false);
    for (const { box: other } of placed.slice(k + 1)) expect(overlap(box, other)).toBe(false);
    for (const { at: [x, y] } of labels)
      expect(overlap(box, { left: x - 5, top: y - 5, right: x + 5, bottom: y + 5 })).toBe(false);
  });
  expect(placed.some(({ isDetached }) => isDetached)).toBe(true);
});
test('a name at the edge stays in the view', () => {
  for (const [x, y] of [[0, 0], [600, 0], [0, 300], [600, 300]] as const) {
    const [{ box } = { box: room }] = placeLabels([label('Corner', x, y)], room, []);
    expect(box.left).toBeGreaterThanOrEqual(0);
    expect(box.right).toBeLessThanOrEqual(600);
    expect(box.top).toBeGreaterThanOrEqual(0);
    expect(box.bottom).toBeLessThanOrEqual(300);
  }
});
test('points outside the view have no name', () => {
  expect(placeLabels([label('Far', 900, 100)], room, [])).toEqual([]);
});
