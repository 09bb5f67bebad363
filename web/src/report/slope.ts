// What the section shows: the ground, the trajectories and the barriers that it crosses.

import type { Settings } from '../archive/summary';
import { extentOf, type Range } from '../figures/plot';
import type { Rock } from './data';
import { isNumber } from './format';
import { bandUnder, groundBelow, placesOn, type Edges, type Over } from './groundBand';
import { crossingPlace } from './crossingPlace';
import { groundIn } from './relief';
import { barrierLine, barriersOf, nameIn, runs, tableOf, type Run } from './run';
import { meanOf, travel, type Point } from './travel';

/// The terrain of a run in 2D.
export interface Ground {
  run: Run;
  points: readonly Point[];
}
/// The ground under the trajectories of a run in 3D, and of others on the same terrain.
export interface RunBand {
  run: Run;
  band: readonly Edges[];
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
  /// None if a section is drawn.
  bands: readonly RunBand[];
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

// The highest of a section at u.
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

// The terrain of runs in 2D.
const sections = runs.flatMap((run): Ground[] => {
  const points = run.isSection ? run.terrain.section : undefined;
  return points ? [{ run, points }] : [];
});

/// The ground under a trajectory that is projected onto the section; none if a section is drawn.
export function groundUnder({ run, rows }: Rock): Over[] {
  const { relief } = runs[run]!.terrain;
  if (!relief || sections.length > 0) return [];
  return groundBelow(placesOn(rows, relief.cell_m / 2), groundIn(relief), travel.along);
}

const stationCount = 300;
// The ground under all that is drawn of runs in 3D; runs on the same relief have it together.
function bandsWithin([low, high]: Range): RunBand[] {
  const spatial = sections.length > 0 ? [] : runs.flatMap((run) => (run.terrain.relief ? [{ run, relief: run.terrain.relief }] : []));
  const textOf = new Map(spatial.map(({ run, relief }) => [run, JSON.stringify(relief)]));
  const differing = spatial.filter(({ run }, k) => spatial.findIndex((each) => textOf.get(each.run) === textOf.get(run)) === k);
  const stations = { from: low, step: (high - low) / (stationCount - 1), count: stationCount };
  return differing.map(({ run, relief }) => {
    const groundAt = groundIn(relief);
    const ways = spatial
      .filter((each) => textOf.get(each.run) === textOf.get(run))
      .flatMap(({ run: { rocks, endpoints } }) => [
        ...rocks.map(groundUnder),
        ...endpoints.map((end) => groundBelow([end], groundAt, travel.along)),
      ]);
    return { run, band: bandUnder(ways, stations, groundAt, travel.direction) };
  });
}

// Whether the section crosses a line rather than runs along it.
function isCrossed(line: readonly Point[]): boolean {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last || line.length === 1) return true;
  const [dx, dy] = [last[0] - first[0], last[1] - first[1]];
  return Math.abs(dx * travel.direction[0] + dy * travel.direction[1]) <= 0.7 * Math.hypot(dx, dy);
}

// Where a barrier stands in the drawing: on a section at its place, in 3D where the trajectories cross it.
function standOf(run: Run, line: readonly Point[]): { u: number; foot: number | null } {
  const { relief } = run.terrain;
  if (sections.length > 0 || !relief) {
    const u = travel.along(meanOf(line.map(([x, y]) => ({ x, y }))));
    const ground = sections.find((each) => each.run === run) ?? sections[0];
    return { u, foot: ground ? heightAt(ground.points, u) : null };
  }
  const place = crossingPlace(line, run.rocks.map(({ rows }) => rows));
  return { u: travel.along(place), foot: groundIn(relief)(place.x, place.y) };
}

function wallOf(run: Run, barrier: Settings): Wall | null {
  const line = barrierLine(barrier);
  const { height_m, inclination_deg } = barrier;
  if (line.length === 0 || !isNumber(height_m) || !isCrossed(line)) return null;
  const { u, foot } = standOf(run, line);
  if (foot === null) return null;
  const lean = isNumber(inclination_deg) ? (inclination_deg * Math.PI) / 180 : 0;
  return { name: nameIn(barrier), height_m, u, foot, top: [u - height_m * Math.sin(lean), foot + height_m * Math.cos(lean)] };
}

// A barrier of both runs is drawn once.
function wallsOfRuns(): Wall[] {
  const all = runs.flatMap((run) => barriersOf(run).flatMap((barrier) => wallOf(run, barrier) ?? []));
  return all.filter((wall, k) => all.findIndex(({ name, u }) => name === wall.name && u === wall.u) === k);
}

/// Null if the runs have neither a section nor trajectories.
export const slope = ((): Slope | null => {
  const rocks = runs.flatMap((run) => run.rocks);
  if (sections.length === 0 && rocks.length === 0) return null;
  const ends = runs.flatMap(({ endpoints }) => endpoints);
  const reached = [...rocks.flatMap(({ rows }) => rows.map(travel.along)), ...ends.map(travel.along)];
  const grounds = sections;
  const bands = bandsWithin(extentOf(reached, 0.12));
  const points = [
    ...grounds.flatMap((ground) => ground.points),
    ...bands.flatMap(({ band }) => band.flatMap(({ u, low, high }) => u.flatMap((at, k): Point[] => [[at, low[k]!], [at, high[k]!]]))),
  ];
  const us = [...reached, ...points.map(([u]) => u)];
  const walls = wallsOfRuns();
  const zs = [...rocks.flatMap(heightsOf), ...ends.map(({ z }) => z), ...points.map(([, z]) => z), ...walls.map(({ top }) => top[1])];
  const [first, second] = grounds;
  const agree = second !== undefined && JSON.stringify(first?.points) === JSON.stringify(second.points);
  return { grounds, bands, walls, agree, u: extentOf(us, 0.02), z: extentOf(zs, 0.06) };
})();
