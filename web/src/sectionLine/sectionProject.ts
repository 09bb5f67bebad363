// The text of a 2D project from a section of a 3D one: the ground along the line, the same materials and settings, the
// seeders that start in the corridor, and the barriers that cross the line.

import type { GroundSection, Model, ModelBarrier, ModelSeeder, Point2 } from '../api/types';
import type { Edit, Path, Row } from '../settings/names';
import { isTable } from '../settings/tables';
import { edited } from '../toml/edit';
import type { TomlTable, TomlValue } from '../toml/format';
import { placeOnLine } from './corridor';

export interface SectionProject {
  text: string;
  /// What is not as in the 3D project, as sentences.
  notes: string[];
}

/// The longest part without gaps: x and z of its vertices, and the material of each segment.
export function longestPart({ distance_m, z_m, materials }: GroundSection): { vertices: Point2[]; materials: (number | null)[] } {
  let best: number[] = [];
  let now: number[] = [];
  z_m.forEach((z, k) => {
    if (z === null) now = [];
    else now.push(k);
    const length = (part: number[]) => (part.length > 1 ? distance_m[part.at(-1)!]! - distance_m[part[0]!]! : 0);
    if (length(now) > length(best)) best = [...now];
  });
  return {
    vertices: best.map((k) => [distance_m[k]!, z_m[k]!]),
    materials: best.slice(0, -1).map((k) => materials[k] ?? null),
  };
}

/// The vertices to a millimetre, without those that make no bend and no change of the material.
export function withoutStraight(vertices: readonly Point2[], materials: readonly number[]): { vertices: Point2[]; materials: number[] } {
  const all = vertices.map(([x, z]): Point2 => [millimetres(x), millimetres(z)]);
  const kept: { vertices: Point2[]; materials: number[] } = { vertices: all.slice(0, 1), materials: [] };
  const isSame = ([x, z]: Point2, [u, w]: Point2) => x === u && z === w;
  // Whether the vertices between two others are less than a millimetre from the straight line between these.
  const isStraight = (first: number, last: number) => {
    const [[x, z], [u, w]] = [all[first]!, all[last]!];
    const length = Math.hypot(u - x, w - z);
    return all.slice(first + 1, last).every(([p, q]) => Math.abs((p - x) * (w - z) - (q - z) * (u - x)) <= 1e-3 * length);
  };
  let first = 0;
  for (let k = 1; k < all.length; ++k) {
    // The material of the part from the last kept vertex is that of its first piece that has a length.
    let piece = first;
    while (piece < k && isSame(all[piece]!, all[piece + 1]!)) ++piece;
    if (piece === k) {
      first = k;
      continue;
    }
    const isLast = k === all.length - 1;
    const next = isLast ? undefined : all[k + 1]!;
    const isRepeated = next !== undefined && isSame(all[k]!, next);
    if (!isLast && (isRepeated || (materials[k] === materials[piece] && isStraight(first, k + 1)))) continue;
    kept.vertices.push(all[k]!);
    kept.materials.push(materials[piece]!);
    first = k;
  }
  return kept;
}

const millimetres = (value: number) => Number(value.toFixed(3));

/// The direction of the line at a distance along it.
function headingAt(line: readonly Point2[], distance: number): Point2 {
  let way = 0;
  let heading: Point2 = [1, 0];
  for (let k = 1; k < line.length && (way <= distance || k === 1); ++k) {
    const [dx, dy] = [line[k]![0] - line[k - 1]![0], line[k]![1] - line[k - 1]![1]];
    const length = Math.hypot(dx, dy);
    if (length > 0) heading = [dx / length, dy / length];
    way += length;
  }
  return heading;
}

const sizes = ['mass_kg', 'volume_m3', 'diameter_m', 'density_kg_m3'] as const;
const velocities = ['horizontal_velocity_m_s', 'vertical_velocity_m_s', 'speed_m_s', 'rotational_velocity_deg_s'] as const;

/// The direction of a release in the section: forwards or backwards along it, and up if it is one in space.
function directionOf(row: Row<'seeder'>, [ux, uy]: Point2): TomlValue | undefined {
  if (row.horizontal_velocity_m_s === undefined && row.speed_m_s === undefined && row.rotational_velocity_deg_s === undefined) return undefined;
  const isArea = row.type === 'polygon' || row.type === 'raster';
  const given = row.direction ?? (isArea ? 'downslope' : [1, 0, 0]);
  if (!Array.isArray(given)) return given; // downslope
  const [x = 0, y = 0, z = 0] = given.map(Number);
  const along = x * ux + y * uy >= 0 ? Math.hypot(x, y) : -Math.hypot(x, y);
  return row.speed_m_s === undefined ? [along >= 0 ? 1 : -1, 0] : [millimetres(along), z];
}

/// The seeder in the section; null if none of its rocks start in the corridor.
function seederIn(line: readonly Point2[], halfWidth: number, from: Point2, of: ModelSeeder, row: Row<'seeder'>): Row<'seeder'> | null {
  const place = placeOnLine(line);
  const [first, last] = from;
  const inside = of.points.flatMap(([x, y, z]) => {
    const { distance, aside, isBeyond } = place(x, y);
    return !isBeyond && aside <= halfWidth && distance >= first && distance <= last ? [{ distance, z }] : [];
  });
  if (inside.length === 0) return null;
  inside.sort((a, b) => a.distance - b.distance);
  const [low, high] = [inside[0]!, inside.at(-1)!];
  const middle = inside[Math.floor(inside.length / 2)]!;
  const isPoint = high.distance - low.distance < 1; // m
  const own = row.position ?? (Array.isArray(row.points) ? row.points[0] : undefined);
  const hasHeight = Array.isArray(own) && typeof own[2] === 'number' && row.height_above_m === undefined;
  const positionAt = ({ distance, z }: typeof low): TomlValue[] =>
    hasHeight ? [millimetres(distance), millimetres(z)] : row.height_above_m === undefined ? [millimetres(distance), 'surface'] : [millimetres(distance)];
  const kept = [...sizes, ...velocities].flatMap((key) => (row[key] === undefined ? [] : [[key, row[key]] as const]));
  const direction = directionOf(row, headingAt(line, middle.distance));
  return {
    name: of.name,
    ...(typeof row.source === 'string' && { source: row.source }),
    ...(isPoint ? { type: 'point', position: positionAt(middle) } : { type: 'line', points: [positionAt(low), positionAt(high)] }),
    ...(row.height_above_m !== undefined && { height_above_m: row.height_above_m }),
    rocks: Math.max(1, Math.round((of.rocks * inside.length) / of.points.length)),
    ...Object.fromEntries(kept),
    ...(direction !== undefined && { direction }),
  };
}

/// The first place at which the foot of a barrier crosses the line, and whether the barrier leans forwards along it.
export function crossingOf({ foot }: ModelBarrier, line: readonly Point2[]): { distance: number; leansForwards: boolean } | null {
  let way = 0;
  for (let k = 1; k < line.length; ++k) {
    const [[ax, ay], [bx, by]] = [line[k - 1]!, line[k]!];
    const [dx, dy] = [bx - ax, by - ay];
    const length = Math.hypot(dx, dy);
    let nearest: { distance: number; leansForwards: boolean } | null = null;
    for (let i = 1; i < foot.length; ++i) {
      const [[px, py], [qx, qy]] = [foot[i - 1]!, foot[i]!];
      const [ex, ey] = [qx - px, qy - py];
      const across = dx * ey - dy * ex;
      if (across === 0) continue;
      const s = ((px - ax) * ey - (py - ay) * ex) / across;
      const t = ((px - ax) * dy - (py - ay) * dx) / across;
      if (s < 0 || s > 1 || t < 0 || t > 1) continue;
      // It leans to the right of its own direction.
      const found = { distance: way + s * length, leansForwards: ey * dx - ex * dy > 0 };
      if (!nearest || found.distance < nearest.distance) nearest = found;
    }
    if (nearest) return nearest;
    way += length;
  }
  return null;
}

const only3d: readonly Path[] = [
  ['ground'],
  ['area'],
  ['seeder'],
  ['barrier'],
  ['collector'],
  ['layer'],
  ['design', 'section_m'],
  ['output', 'runout_from'],
  ['output', 'runout_along'],
  ['output', 'maps_by_source'],
  ['output', 'geopackage'],
];

/// `values` are those of the text.
export function sectionProject(
  text: string,
  values: TomlTable,
  model: Model,
  section: GroundSection,
  line: readonly Point2[],
  halfWidth: number,
  name: string,
): SectionProject {
  const rowsOf = (key: string) => (Array.isArray(values[key]) ? values[key] : []).filter(isTable);
  const rowAt = (path: string): Row => (rowsOf(path.split('.')[0]!)[Number(path.split('.')[1])] ?? {}) as Row;
  const part = longestPart(section);
  let last = part.materials.find((each) => each !== null) ?? 0;
  // A step has no material of its own: it continues the one before.
  const known = part.materials.map((each) => (last = each ?? last));
  const { vertices, materials } = withoutStraight(part.vertices, known);
  const notes: string[] = [];
  const edits: Edit[] = [{ set: ['name'], value: name }];
  for (const key of Object.keys(isTable(values.terrain) ? values.terrain : {})) edits.push({ remove: ['terrain', key] as Path });
  edits.push({ set: ['terrain', 'section'], value: vertices });
  edits.push(...only3d.map((path) => ({ remove: path })));
  if (isTable(values.output) && values.output.raster_cell_m === 'terrain') edits.push({ remove: ['output', 'raster_cell_m'] });
  if (model.materials.length > 1) edits.push({ set: ['ground', 'segments'], value: materials.map((each) => model.materials[each]!) });

  const ends: Point2 = [vertices[0]?.[0] ?? 0, vertices.at(-1)?.[0] ?? 0];
  const outside: string[] = [];
  for (const seeder of model.seeders) {
    const row = rowAt(seeder.path) as Row<'seeder'>;
    if (row.type === 'table') {
      notes.push(`${seeder.name} is left out, because its rocks are in a table.`);
      continue;
    }
    const made = seederIn(line, halfWidth, ends, seeder, row);
    if (made) edits.push({ append: ['seeder'], value: made as Row });
    else outside.push(seeder.name);
  }
  if (outside.length > 0) notes.push(`No rock starts in the corridor from ${outside.join(', ')}.`);
  if (outside.length === model.seeders.length) notes.push('Add a seeder: where do rocks start?');

  for (const barrier of model.barriers) {
    const crossing = crossingOf(barrier, line);
    if (!crossing || crossing.distance < ends[0] || crossing.distance > ends[1]) continue;
    const row = rowAt(barrier.path) as Row<'barrier'>;
    const lean = typeof row.inclination_deg === 'number' && !crossing.leansForwards ? -row.inclination_deg : row.inclination_deg;
    edits.push({
      append: [barrier.kind],
      value: { ...row, name: barrier.name, line: millimetres(crossing.distance), ...(lean !== undefined && { inclination_deg: lean }) } as Row,
    });
  }
  return { text: edited(text, edits), notes };
}
