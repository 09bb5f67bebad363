// What the section shows: the ground, the trajectories and the barriers that it crosses.

import type { Relief, Settings } from '../archive/summary';
import { extentOf, type Range } from '../figures/plot';
import type { Rock } from './data';
import { isNumber } from './format';
import { reliefHeight } from './relief';
import { barrierLine, barriersOf, nameIn, runs, tableOf, type Run } from './run';
import { meanOf, travel, type Point } from './travel';

export interface Ground {
  run: Run;
  points: readonly Point[];
  /// The terrain of a run in 2D, rather than a line across one in 3D.
  isSection: boolean;
}
export interface Wall {
  name: string;
  height_m: number;
  u: number;
  /// The elevation of its foot.
  foot: number;
  top: Point;
}
export interface Slope {
  grounds: readonly Ground[];
  walls: readonly Wall[];
  /// Whether two runs have the same ground.
  agree: boolean;
  u: Range;
  z: Range;
}

const standardGravity = 9.80665;

// Elevations of the rows of a rock and of the vertices of its parabolas.
function heightsOf({ run, rows }: Rock): number[] {
  const given = tableOf(runs[run]!, 'analysis').gravity_m_s2;
  const gravity = isNumber(given) && given !== 0 ? given : standardGravity;
  return rows.flatMap(({ state, z, vz }) => (state === 'projectile' && vz > 0 ? [z, z + vz ** 2 / (2 * gravity)] : [z]));
}

// The highest of the ground at u.
function heightAt(points: readonly Point[], u: number): number | null {
  let highest: number | null = null;
  points.slice(1).forEach((b, k) => {
    const a = points[k]!;
    if (u < Math.min(a[0], b[0]) || u > Math.max(a[0], b[0])) return;
    const z = a[0] === b[0] ? Math.max(a[1], b[1]) : a[1] + ((b[1] - a[1]) * (u - a[0])) / (b[0] - a[0]);
    highest = highest === null ? z : Math.max(highest, z);
  });
  return highest;
}

// The terrain along the section line through the mean release point, within the relief.
function reliefProfile(relief: Relief, [low, high]: Range): Point[] {
  const steps = 600;
  const middle = relief.y0 + (relief.cell_m * (relief.rows - 1)) / 2;
  const { origin, direction, isX } = travel;
  return Array.from({ length: steps + 1 }, (_, k) => low + ((high - low) * k) / steps).flatMap((u): Point[] => {
    const [x, y] = isX ? [u, middle] : [origin.x + u * direction[0], origin.y + u * direction[1]];
    const z = reliefHeight(relief, x, y);
    return z === null ? [] : [[u, z]];
  });
}

// The grounds that are drawn: sections of runs in 2D, or else lines across the reliefs of runs in 3D.
function groundsWithin(reach: Range): Ground[] {
  const sections = runs.flatMap((run): Ground[] => {
    const points = run.isSection ? run.terrain.section : undefined;
    return points ? [{ run, points, isSection: true }] : [];
  });
  if (sections.length > 0) return sections;
  return runs.flatMap((run): Ground[] => {
    const { relief } = run.terrain;
    return !run.isSection && relief ? [{ run, points: reliefProfile(relief, reach), isSection: false }] : [];
  });
}

// Whether the section crosses a line rather than runs along it.
function isCrossed(line: readonly Point[]): boolean {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last || line.length === 1) return true;
  const [dx, dy] = [last[0] - first[0], last[1] - first[1]];
  return Math.abs(dx * travel.direction[0] + dy * travel.direction[1]) <= 0.7 * Math.hypot(dx, dy);
}

function wallOf(run: Run, barrier: Settings, grounds: readonly Ground[]): Wall | null {
  const line = barrierLine(barrier);
  const { height_m, inclination_deg } = barrier;
  if (line.length === 0 || !isNumber(height_m) || !isCrossed(line)) return null;
  const u = travel.along(meanOf(line.map(([x, y]) => ({ x, y }))));
  const ground = grounds.find((each) => each.run === run) ?? grounds[0];
  const foot = ground ? heightAt(ground.points, u) : null;
  if (foot === null) return null;
  const lean = isNumber(inclination_deg) ? (inclination_deg * Math.PI) / 180 : 0;
  return { name: nameIn(barrier), height_m, u, foot, top: [u - height_m * Math.sin(lean), foot + height_m * Math.cos(lean)] };
}

// A barrier of both runs is drawn once.
function wallsOn(grounds: readonly Ground[]): Wall[] {
  const all = runs.flatMap((run) => barriersOf(run).flatMap((barrier) => wallOf(run, barrier, grounds) ?? []));
  return all.filter((wall, k) => all.findIndex(({ name, u }) => name === wall.name && u === wall.u) === k);
}

/// Null if the runs have neither a section nor trajectories.
export const slope = ((): Slope | null => {
  const rocks = runs.flatMap((run) => run.rocks);
  const ends = runs.flatMap(({ endpoints }) => endpoints);
  const reached = [...rocks.flatMap(({ rows }) => rows.map(travel.along)), ...ends.map(travel.along)];
  const grounds = groundsWithin(extentOf(reached, 0.12));
  const points = grounds.flatMap((ground) => ground.points);
  const us = [...reached, ...points.map(([u]) => u)];
  if (us.length === 0) return null;
  const walls = wallsOn(grounds);
  const zs = [...rocks.flatMap(heightsOf), ...ends.map(({ z }) => z), ...points.map(([, z]) => z), ...walls.map(({ top }) => top[1])];
  const [first, second] = grounds;
  const agree = second !== undefined && JSON.stringify(first?.points) === JSON.stringify(second.points);
  return { grounds, walls, agree, u: extentOf(us, 0.02), z: extentOf(zs, 0.06) };
})();
