// A slope in section while its shape is changed: pure functions of its vertices, materials and standard deviations.

import type { Point2 } from '../api/types';
import { isTable } from '../settings/tables';
import type { TomlTable, TomlValue } from '../toml/format';

export interface Slope {
  /// x ascends; equal x: a vertical step.
  vertices: Point2[];
  /// One for each segment; null: the default everywhere.
  materials: TomlValue[] | null;
  /// One for each vertex; null: vertices are fixed.
  deviations: TomlValue[] | null;
}

/// A number or shape that cannot be; its message says why.
export class Impossible extends Error {}

const fixed: TomlValue = [0, 0];
const rowsIn = (value: TomlValue | undefined): TomlValue[] | null => (Array.isArray(value) && value.length > 0 ? value : null);

function parallel(what: string, list: TomlValue[] | null, expected: number): TomlValue[] | null {
  if (list && list.length !== expected)
    throw new Impossible(`${what} has ${list.length} entries and the section needs ${expected}. Correct it first.`);
  return list;
}

/// The slope as the project has it, from left to right.
export function slopeIn(values: TomlTable): { slope: Slope; isListedLeftwards: boolean } {
  const terrain = isTable(values.terrain) ? values.terrain : {};
  const rows = rowsIn(terrain.section) ?? [];
  const isPair = (row: TomlValue) => Array.isArray(row) && row.length === 2 && row.every((cell) => typeof cell === 'number' && Number.isFinite(cell));
  if (terrain.width_m !== undefined) throw new Impossible('The section is extruded to 3D. Slope tools are for sections in 2D.');
  if (typeof terrain.section === 'string')
    throw new Impossible('The section is in a file. Take its vertices into the project first, under Terrain.');
  if (rows.length < 2 || !rows.every(isPair)) throw new Impossible('The section needs two or more vertices x, z.');
  const vertices = rows as Point2[];
  const ground = isTable(values.ground) ? values.ground : {};
  const slope: Slope = {
    vertices,
    materials: parallel('ground.segments', rowsIn(ground.segments), rows.length - 1),
    deviations: parallel('terrain.section_std_dev_m', rowsIn(terrain.section_std_dev_m), rows.length),
  };
  const isListedLeftwards = vertices[0]![0] > vertices.at(-1)![0];
  const left = isListedLeftwards ? reversed(slope) : slope;
  if (left.vertices.some(([x], k) => k > 0 && x < left.vertices[k - 1]![0]))
    throw new Impossible('The section folds back in x. Slope tools need vertices in one direction.');
  return { slope: left, isListedLeftwards };
}

const reversed = ({ vertices, materials, deviations }: Slope): Slope => ({
  vertices: vertices.toReversed(),
  materials: materials?.toReversed() ?? null,
  deviations: deviations?.toReversed() ?? null,
});
const minus = (x: number) => (x === 0 ? 0 : -x);
export const mirrored = (slope: Slope): Slope => {
  const back = reversed(slope);
  return { ...back, vertices: back.vertices.map(([x, z]) => [minus(x), z]) };
};
/// In the order of the project.
export const asListed = (slope: Slope, isListedLeftwards: boolean): Slope => (isListedLeftwards ? reversed(slope) : slope);

/// A place on the ground, and the vertices around it.
export interface Place {
  point: Point2;
  /// The last vertex before it and the first one after it; between them there is the vertex that it is, or none.
  before: number;
  after: number;
}

export const firstX = ({ vertices }: Slope) => vertices[0]![0];
export const lastX = ({ vertices }: Slope) => vertices.at(-1)![0];

/// The ground at x; at a vertical step its lower or upper end.
export function groundAt({ vertices }: Slope, x: number, end: 'low' | 'high' = 'low'): Place {
  let found: number | null = null;
  vertices.forEach(([vx, vz], k) => {
    if (vx === x && (found === null || (end === 'low' ? vz < vertices[found]![1] : vz > vertices[found]![1]))) found = k;
  });
  if (found !== null) return { point: vertices[found]!, before: found - 1, after: found + 1 };
  const after = vertices.findIndex(([vx]) => vx > x);
  if (after <= 0) throw new Impossible(`x = ${shown(x)} is off the section`);
  const [[ax, az], [bx, bz]] = [vertices[after - 1]!, vertices[after]!];
  return { point: [x, az + ((x - ax) / (bx - ax)) * (bz - az)], before: after - 1, after };
}

/// The first place at which a ray meets the ground; null: none.
export function meeting({ vertices }: Slope, [x, z]: Point2, [dx, dz]: Point2): Place | null {
  const least = 1e-9;
  let best: { way: number; place: Place } | null = null;
  for (let k = 0; k + 1 < vertices.length; ++k) {
    const [[ax, az], [bx, bz]] = [vertices[k]!, vertices[k + 1]!];
    const across = dx * (bz - az) - dz * (bx - ax);
    if (across === 0) continue;
    const way = ((ax - x) * (bz - az) - (az - z) * (bx - ax)) / across;
    const share = ((ax - x) * dz - (az - z) * dx) / across;
    if (way <= least || share < 0 || share > 1 || (best && way >= best.way)) continue;
    const vertex = share === 0 ? k : share === 1 ? k + 1 : null;
    const place: Place =
      vertex !== null
        ? { point: vertices[vertex]!, before: vertex - 1, after: vertex + 1 }
        : { point: [ax + share * (bx - ax), az + share * (bz - az)], before: k, after: k + 1 };
    best = { way, place };
  }
  return best?.place ?? null;
}

/// New vertices have whole millimetres, those on the old ground micrometres in z.
const [millimetre, micrometre] = [3, 6];
const short = (value: number, digits: number) => Number(value.toFixed(digits)) || 0;
export const shown = (value: number) => String(short(value, 2));

/// A place on the ground at whole millimetres of x.
function settled(slope: Slope, place: Place): Place {
  if (place.after - place.before > 1) return place;
  const [a, b] = [slope.vertices[place.before]!, slope.vertices[place.after]!];
  if (a[0] === b[0]) return { ...place, point: [a[0], short(place.point[1], micrometre)] };
  const x = short(place.point[0], millimetre);
  if (x <= a[0]) return { point: a, before: place.before - 1, after: place.after };
  if (x >= b[0]) return { point: b, before: place.before, after: place.after + 1 };
  return { ...place, point: [x, short(groundAt(slope, x).point[1], micrometre)] };
}

/// The material of the ground at x, of the left one of two.
function materialAt({ vertices, materials }: Slope, x: number): TomlValue {
  const k = vertices.findIndex(([vx], i) => i > 0 && vx >= x && vertices[i - 1]![0] < vx);
  return materials![Math.max(0, k < 0 ? materials!.length - 1 : k - 1)]!;
}

/// The slope with a stretch replaced by other vertices. What lies outside stays, each place keeps its material, and new
/// vertices are fixed.
export function withStretch(slope: Slope, start: Place, middle: readonly Point2[], end: Place): Slope {
  const [from, to] = [settled(slope, start), settled(slope, end)];
  const line = [from.point, ...middle.map(([x, z]): Point2 => [short(x, millimetre), short(z, millimetre)]), to.point];
  line.forEach(([x], k) => {
    if (k > 0 && x < line[k - 1]![0]) throw new Impossible('The numbers leave less than a millimetre between vertices.');
  });
  const { materials, deviations } = slope;
  const isBorder = (k: number) => materials !== null && k > 0 && k < materials.length && materials[k] !== materials[k - 1];
  const borders = slope.vertices.flatMap(([x], k) => (isBorder(k) ? [x] : []));
  const split: Point2[] = [line[0]!];
  for (const next of line.slice(1)) {
    const last = split.at(-1)!;
    for (const x of borders)
      if (x > last[0] && x < next[0]) split.push([x, short(last[1] + ((x - last[0]) / (next[0] - last[0])) * (next[1] - last[1]), micrometre)]);
    if (next[0] !== last[0] || next[1] !== last[1]) split.push(next);
  }
  const [head, tail] = [from.before + 1, to.after];
  const vertexOf = (place: Place) => (place.after - place.before > 1 ? place.before + 1 : null);
  const deviationOf = (place: Place) => deviations![vertexOf(place) ?? -1] ?? fixed;
  return {
    vertices: [...slope.vertices.slice(0, head), ...split, ...slope.vertices.slice(tail)],
    materials:
      materials && [
        ...materials.slice(0, head),
        ...split.slice(1).map(([x], k) => materialAt(slope, (split[k]![0] + x) / 2)),
        ...materials.slice(tail - 1),
      ],
    deviations:
      deviations && [
        ...deviations.slice(0, head),
        deviationOf(from),
        ...split.slice(1, -1).map(() => fixed),
        deviationOf(to),
        ...deviations.slice(tail),
      ],
  };
}

/// The areas between two slopes with the same ends [m2 per m].
export function areasBetween(before: Slope, after: Slope): { cut: number; fill: number } {
  const xs = [...new Set([...before.vertices, ...after.vertices].map(([x]) => x))].sort((a, b) => a - b);
  const runner = ({ vertices }: Slope) => {
    let k = 0;
    return (from: number, to: number): Point2 => {
      while (k + 2 < vertices.length && vertices[k + 1]![0] <= from) ++k;
      const [[ax, az], [bx, bz]] = [vertices[k]!, vertices[k + 1]!];
      const at = (x: number) => (x === ax ? az : x === bx ? bz : az + ((x - ax) / (bx - ax)) * (bz - az));
      return [at(from), at(to)];
    };
  };
  const [old, next] = [runner(before), runner(after)];
  let [cut, fill] = [0, 0];
  const add = (width: number, mean: number) => (mean > 0 ? (cut += width * mean) : (fill -= width * mean));
  for (let k = 0; k + 1 < xs.length; ++k) {
    const [from, to] = [xs[k]!, xs[k + 1]!];
    const [a, b] = [old(from, to), next(from, to)];
    const [first, last] = [a[0] - b[0], a[1] - b[1]];
    if (first * last < 0) {
      const share = first / (first - last);
      add(share * (to - from), first / 2);
      add((1 - share) * (to - from), last / 2);
    } else add(to - from, (first + last) / 2);
  }
  return { cut, fill };
}
