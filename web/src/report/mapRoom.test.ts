import { expect, test } from 'vitest';
import { drawing } from './figure';
import { mapRoom, mapScaleIn, mapWidth, metresPerUnit, roundLength, unitsPerMetre, type View } from './mapRoom';

const view = (x: number, y: number): View => ({ x: [0, x], y: [0, y] });

test('scale bars have a round length', () => {
  expect([0.7, 1, 16, 49, 200, 5300].map(roundLength)).toEqual([0.5, 1, 10, 20, 200, 5000]);
});

test('a tall map takes half the width', () => {
  expect([view(3, 1), view(1, 1), view(1, 3)].map(mapWidth)).toEqual([drawing.wide, drawing.half, drawing.half]);
});

test('a view fits at its round scale, and would not at a scale a third larger', () => {
  const room = mapRoom(drawing.wide);
  for (const shown of [view(5, 5), view(1000, 70), view(123.4, 2345.6)]) {
    const denominator = mapScaleIn(room, shown);
    const per = 1 / unitsPerMetre(denominator);
    expect(per).toBeGreaterThanOrEqual(metresPerUnit(room, shown) * (1 - 1e-9));
    expect(per / 1.5).toBeLessThan(metresPerUnit(room, shown));
  }
});
