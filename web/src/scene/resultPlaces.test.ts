import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { resultPlaces } from './resultPlaces';

const shift = new Vector3(100, 0, -50);

test('the places of a result surround its trajectories with a margin', () => {
  const { places, box } = resultPlaces({ positions: new Float32Array([0, 0, 0, 200, 100, -60, 100, 50, -10]) }, shift);
  expect(places[0]!.toArray()).toEqual([85, -7.5, -45.5].map((value) => expect.closeTo(value)));
  expect(box.max.toArray()).toEqual([315, 107.5, -45.5].map((value) => expect.closeTo(value)));
});

test('a rock that stays where it was released is shown with its surroundings', () => {
  const { box } = resultPlaces({ positions: new Float32Array([0, 0, 0, 0, 0, 0]) }, shift);
  expect(box.getSize(new Vector3()).toArray()).toEqual([20, 20, 0]);
});

test('of many points two thousand are taken, over all trajectories', () => {
  const positions = new Float32Array(3 * 10_000).map((_, k) => (k % 3 === 0 ? k / 3 : 0));
  const { places } = resultPlaces({ positions }, new Vector3());
  expect(places.length).toBeLessThan(2010);
  expect(places.at(-3)!.x - places[0]!.x).toBeGreaterThan(11_400);
});
