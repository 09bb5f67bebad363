import { expect, test } from 'vitest';
import { bandUnder, groundBelow, placesOn, type Edges, type GroundAt } from './groundBand';

const along = ({ x }: { x: number }) => x;
const stations = { from: -20, step: 0.5, count: 281 }; // up to 120
const direction = [1, 0] as const;
const plane: GroundAt = (x) => 100 - 0.5 * x;
const ridge: GroundAt = (x, y) => 100 - 0.2 * x - 0.8 * Math.abs(y); // its crest is the line y = 0

/// A rock that slides from the origin to (100, y), on the ground.
const slide = (groundAt: GroundAt, y: number) =>
  Array.from({ length: 51 }, (_, k) => {
    const place = { x: 2 * k, y: (y * k) / 50 };
    return { state: 'sliding', time: k, ...place, z: groundAt(place.x, place.y)!, vz: 0 };
  });
const wayOf = (groundAt: GroundAt, rows: ReturnType<typeof slide>) => groundBelow(placesOn(rows, 1), groundAt, along);
function edgeAt({ u }: Edges, edge: readonly number[], at: number): number {
  const k = Math.min(u.findIndex((next) => next >= at), u.length - 1);
  if (k <= 0) return edge[0]!;
  return edge[k - 1]! + ((edge[k]! - edge[k - 1]!) * (at - u[k - 1]!)) / (u[k]! - u[k - 1]!);
}

test('on a plane the band has no width, and goes on beyond the trajectories', () => {
  const [band, ...others] = bandUnder([-10, 0, 10].map((y) => wayOf(plane, slide(plane, y))), stations, plane, direction);
  expect(others).toEqual([]);
  expect(band!.u).toHaveLength(stations.count);
  band!.u.forEach((u, k) => {
    expect(band!.low[k]).toBeCloseTo(plane(u, 0)!, 6);
    expect(band!.high[k]).toBeCloseTo(plane(u, 0)!, 6);
  });
});

test('no rock of a fan is below the band, though all but one are below the ground of the section line', () => {
  const fan = [-60, -35, -10, 0, 20, 50].map((y) => slide(ridge, y));
  const ways = fan.map((rows) => wayOf(ridge, rows));
  const [band] = bandUnder(ways, stations, ridge, direction);
  let below = 0;
  for (const { u, ground } of ways.flat()) {
    expect(edgeAt(band!, band!.low, u)).toBeLessThan(ground + 1e-6);
    expect(edgeAt(band!, band!.high, u)).toBeGreaterThan(ground - 1e-6);
    if (ground < ridge(u, 0)! - 1) ++below;
  }
  expect(below).toBeGreaterThan(300);
  // The band is the ground under the outermost rocks: no wider than they are.
  expect(edgeAt(band!, band!.high, 50)).toBeCloseTo(ridge(50, 0)!, 6);
  expect(edgeAt(band!, band!.low, 50)).toBeCloseTo(ridge(50, -30)!, 6);
});

test('the band contains the ground between stations, and a step of it where it is', () => {
  const cliff: GroundAt = (x) => (x < 50.2 ? 100 : 40);
  const way = wayOf(cliff, slide(cliff, 0)).concat([{ u: 50.1, x: 50.1, y: 0, ground: 100 }, { u: 50.3, x: 50.3, y: 0, ground: 40 }]);
  const [band] = bandUnder([way.sort((a, b) => a.u - b.u)], stations, cliff, direction);
  expect(edgeAt(band!, band!.high, 50.1)).toBeGreaterThan(100 - 1e-6);
  expect(edgeAt(band!, band!.low, 50.3)).toBeLessThan(40 + 1e-6);
  expect(Math.max(...band!.high)).toBeLessThan(100 + 1e-6);
  expect(Math.min(...band!.low)).toBeGreaterThan(40 - 1e-6);
  for (const u of [40, 60]) expect(edgeAt(band!, band!.high, u) - edgeAt(band!, band!.low, u)).toBeCloseTo(0, 6);
});

test('between groups of rocks the band is the ground on the way from one to the next, and has a hole where there is none', () => {
  const early = [{ u: 0, x: 0, y: 0, ground: ridge(0, 0)! }];
  const late = [{ u: 80, x: 80, y: 40, ground: ridge(80, 40)! }];
  const [band] = bandUnder([early, late], stations, ridge, direction);
  expect(edgeAt(band!, band!.low, 40)).toBeCloseTo(ridge(40, 20)!, 6);
  const holed: GroundAt = (x, y) => (x > 30 && x < 50 ? null : ridge(x, y));
  const pieces = bandUnder([early, late], stations, holed, direction);
  expect(pieces.map(({ u }) => [u[0], u.at(-1)])).toEqual([[-20, 30], [50, 120]]);
});

test('a flight is followed on its parabola, and ground above a rock is put at the rock', () => {
  const [g, time] = [10, 2];
  const flight = [
    { state: 'projectile', time: 0, x: 0, y: 0, z: 50, vz: 5 },
    { state: 'impact', time, x: 8, y: 6, z: 50 + 5 * time - (g * time ** 2) / 2, vz: -15 },
  ];
  const places = placesOn(flight, 1);
  expect(places).toHaveLength(11);
  expect(places[5]).toEqual({ x: 4, y: 3, z: expect.closeTo(50 + 5 - g / 2, 9) });
  expect(groundBelow(places, () => 45, along).map(({ ground }) => ground)).toEqual(places.map(({ z }) => Math.min(45, z)));
  expect(places.at(-1)!.z).toBe(40);
  expect(groundBelow(places, () => null, along)).toEqual([]);
});
