// The parts of a project that have vertices in the view: release places and lines, barriers, areas, forests, the section.

import type { Path } from '../settings/names';
import { isTable } from '../settings/tables';
import type { TomlTable, TomlValue } from '../toml/format';

export interface Shape {
  /// Of the setting that has the vertices.
  path: Path;
  kind: 'points' | 'line' | 'polygon';
  /// The vertices as in the project: x and y, or in a section x and z; after a place on plan its height, if any.
  rows: TomlValue[][];
  /// The fewest vertices that it can have.
  least: number;
}

const isRow = (value: unknown): value is TomlValue[] =>
  Array.isArray(value) && typeof value[0] === 'number' && value.every((cell) => typeof cell === 'number' || typeof cell === 'string');
const rowsIn = (value: unknown): TomlValue[][] => (Array.isArray(value) && value.every(isRow) ? value : []);

/// The number of coordinates of a vertex on plan: 2D has only x.
const onPlan = (is2d: boolean) => (is2d ? 1 : 2);

/// The shape of an entry, such as ["barrier", 0], or of the terrain; null if it has none that can be moved.
export function shapeOf(values: TomlTable, entry: Path, is2d: boolean): Shape | null {
  const [table, index] = entry;
  if (table === 'terrain') {
    const section = isTable(values.terrain) ? rowsIn(values.terrain.section) : [];
    if (!is2d || section.length < 2 || section.some(([, z]) => typeof z !== 'number')) return null;
    return { path: ['terrain', 'section'], kind: 'line', rows: section, least: 2 };
  }
  const list = values[String(table)];
  const row = Array.isArray(list) && typeof index === 'number' ? list[index] : undefined;
  if (!isTable(row)) return null;
  const ways = [
    ...(table === 'seeder' ? ([['position', 'points', 1], ['points', 'line', 2], ['polygon', 'polygon', 3]] as const) : []),
    ...(table === 'area' || table === 'forest' ? ([['polygon', 'polygon', 3]] as const) : []),
    ...(table === 'barrier' || table === 'collector' ? ([['line', 'line', 2]] as const) : []),
  ];
  for (const [key, kind, least] of ways) {
    const value = row[key];
    const path = [table, index!, key] as Path;
    // A barrier in 2D is at one x; a position is one vertex.
    if (is2d && key === 'line' && typeof value === 'number') return { path, kind: 'points', rows: [[value]], least: 1 };
    const rows = key === 'position' ? rowsIn(value === undefined ? [] : [value]) : rowsIn(value);
    const isPlain = rows.every((cells) => cells.slice(0, onPlan(is2d)).every((cell) => typeof cell === 'number') && cells.length >= onPlan(is2d));
    if (rows.length >= least && isPlain) return { path, kind, rows, least };
  }
  return null;
}

/// The value of the setting with other vertices.
export function valueOf({ path }: Shape, rows: TomlValue[][]): TomlValue {
  const [row] = rows;
  if (path.at(-1) === 'position') return row!;
  return path.at(-1) === 'line' && row!.length === 1 ? row![0]! : rows;
}

/// A vertex at another place, on plan or, of the section, in it. Its height, if it is given as a number, is `height`.
export function movedRow(row: readonly TomlValue[], place: readonly number[], height: number | null): TomlValue[] {
  return row.map((cell, k) => (k < place.length ? place[k]! : typeof cell === 'number' && height !== null ? height : cell));
}
