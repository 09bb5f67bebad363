import { expect, test } from 'vitest';
import { fairOrder, neededUpTo, opacityOfShare, segmentsOf } from './pathDetail';

/// Rocks that hop down along x with a time step: bounces of 1 m and, between them, of 0.1 m.
function hopping(rocks: number) {
  const [starts, times, positions]: [number[], number[], number[]] = [[], [], []];
  for (let rock = 0; rock < rocks; ++rock) {
    starts.push(times.length);
    let time = 0;
    const add = (x: number, z: number) => {
      times.push(time);
      positions.push(x, rock, z);
    };
    for (let hop = 0; hop < 10; ++hop) {
      const high = hop % 2 === 0 ? 1 : 0.1;
      for (let step = 0; step <= 8; ++step) {
        // The end of a hop and the beginning of the next are at the same time: the velocity changes.
        if (step > 0) time += 0.1;
        add(hop + step / 8, high * 4 * (step / 8) * (1 - step / 8) - hop);
      }
    }
  }
  starts.push(times.length);
  return { starts: Uint32Array.from(starts), times: Float32Array.from(times), positions: Float32Array.from(positions) };
}

/// The largest distance of a rock from where it is drawn at the same time.
function farthest({ times, positions }: ReturnType<typeof hopping>, ends: Uint32Array) {
  let most = 0;
  for (let s = 0; s < ends.length; s += 2) {
    const [a, b] = [ends[s]!, ends[s + 1]!];
    for (let k = a; k <= b; ++k) {
      const share = (times[k]! - times[a]!) / (times[b]! - times[a]!);
      const off = [0, 1, 2].map((axis) => positions[3 * k + axis]! - positions[3 * a + axis]! * (1 - share) - positions[3 * b + axis]! * share);
      most = Math.max(most, Math.hypot(...off));
    }
  }
  return most;
}

test('a drawing within a tolerance shows every rock within it at all times, with fewer points', () => {
  const paths = hopping(5);
  const needed = neededUpTo(paths);
  const order = fairOrder(5);
  let before = Infinity;
  for (const tolerance of [0, 0.02, 0.05, 0.3, 2]) {
    const { ends, share } = segmentsOf(paths, needed, order, null, tolerance, Infinity);
    expect(share).toBe(1);
    expect(farthest(paths, ends)).toBeLessThanOrEqual(tolerance + 1e-5);
    expect(ends.length).toBeLessThan(before);
    before = ends.length;
  }
  // A rock is one segment at last, from its first point to its last.
  expect([...segmentsOf(paths, needed, order, null, 100, Infinity).ends].sort((a, b) => a - b)).toEqual([0, 89, 90, 179, 180, 269, 270, 359, 360, 449]);
});

test('no segment joins two rocks or the two points of an impact', () => {
  const paths = hopping(3);
  for (const tolerance of [0, 0.05]) {
    const { ends } = segmentsOf(paths, neededUpTo(paths), fairOrder(3), null, tolerance, Infinity);
    for (let s = 0; s < ends.length; s += 2) {
      expect(Math.floor(ends[s]! / 90)).toBe(Math.floor(ends[s + 1]! / 90));
      expect(paths.times[ends[s + 1]!]! - paths.times[ends[s]!]!).toBeGreaterThan(0.05);
    }
  }
});

test('a sample is spread over the rocks that pass, and grows by further rocks', () => {
  const paths = hopping(400);
  const [needed, order] = [neededUpTo(paths), fairOrder(400)];
  const passes = Uint8Array.from({ length: 400 }, (_, k) => (k < 200 ? 1 : 0));
  const rocksOf = (most: number) => new Set(segmentsOf(paths, needed, order, passes, 0, most).ends.map((k) => Math.floor(k / 90)));
  const [few, more] = [rocksOf(20 * 80), rocksOf(60 * 80)];
  expect(few.size).toBe(20);
  expect(more.size).toBe(60);
  for (const rock of few) expect(more.has(rock)).toBe(true);
  for (const rock of more) expect(rock).toBeLessThan(200);
  // As many of each quarter.
  for (let quarter = 0; quarter < 4; ++quarter) expect([...few].filter((rock) => Math.floor(rock / 50) === quarter).length).toBeGreaterThanOrEqual(4);
  expect(segmentsOf(paths, needed, order, passes, 0, 20 * 80).share).toBeCloseTo(0.1, 9);
  // One rock at least.
  expect(rocksOf(1).size).toBe(1);
});

test('fewer lines that are more opaque cover as much', () => {
  expect(opacityOfShare(0.45, 1)).toBeCloseTo(0.45, 12);
  const through = (opacity: number, lines: number) => (1 - opacity) ** lines;
  expect(through(opacityOfShare(0.1, 0.25), 5)).toBeCloseTo(through(0.1, 20), 12);
});
