// Further edits that belong to a change, in the same step: settings of another kind are removed, indices are renumbered,
// and lists parallel to segments, vertices or triangles follow them.

import type { Edit, Path, TableName } from './names';
import type { TomlTable, TomlValue } from '../toml/format';
import { holds } from './applies';
import { rowsBefore, segmentsBefore } from './rowMatch';
import { rowEdits } from './rows';
import type { Field } from './schema';
import { tableOf } from './declared';
import { isTable, valueIn } from './tables';

const listIn = (values: TomlTable, path: Path): TomlValue[] => {
  const found = valueIn(values, path);
  return Array.isArray(found) ? found : [];
};

/// Edits a list parallel to `parts` old parts of another list. `was` has the old index of each new part (null: new, with
/// the value `fresh`). A list of the wrong length, edited by hand, stays too short or too long.
function follow(values: TomlTable, path: Path, parts: number, was: (number | null)[], fresh?: TomlValue): Edit[] {
  const given = listIn(values, path);
  if (given.length === 0) return [];
  const known = was.filter((k) => k === null || k < given.length);
  const surplus = known.length === was.length ? given.slice(parts) : [];
  const next = known.map((k) => (k === null ? fresh : given[k])).filter((entry) => entry !== undefined);
  return rowEdits(path, given, [...next, ...surplus]);
}

const noDeviation = [0, 0];

function consequencesOfSection(values: TomlTable, next: TomlValue[]): Edit[] {
  const before = listIn(values, ['terrain', 'section']);
  return [
    ...follow(values, ['ground', 'segments'], before.length - 1, segmentsBefore(before, next)),
    ...follow(values, ['terrain', 'section_std_dev_m'], before.length, rowsBefore(before, next), noDeviation),
  ];
}

/// ground.triangles has the index of a material for each triangle.
function consequencesOfTriangles(values: TomlTable, next: TomlValue[]): Edit[] {
  const before = listIn(values, ['terrain', 'triangles']);
  const name = valueIn(values, ['ground', 'default']);
  const standard = listIn(values, ['material']).findIndex((row) => isTable(row) && row.name === name);
  return follow(values, ['ground', 'triangles'], before.length, rowsBefore(before, next), Math.max(0, standard));
}

/// Triangles refer to vertices by index. Deleting a vertex deletes its triangles. If vertices are added and deleted at
/// once, the list counts as a new one and the indices stay.
function consequencesOfVertices(values: TomlTable, next: TomlValue[]): Edit[] {
  const before = listIn(values, ['terrain', 'vertices']);
  const was = rowsBefore(before, next);
  const now = new Map(was.flatMap((old, k) => (old === null ? [] : [[old, k] as const])));
  if (now.size < Math.min(before.length, next.length)) return [];
  const triangles = listIn(values, ['terrain', 'triangles']);
  const cornersOf = (triangle: TomlValue) => (Array.isArray(triangle) ? triangle : []);
  const isGone = (corner: TomlValue) => typeof corner === 'number' && corner < before.length && !now.has(corner);
  const kept = triangles.flatMap((triangle, k) => (cornersOf(triangle).some(isGone) ? [] : [k]));
  const renumbered = kept.map((k) =>
    Array.isArray(triangles[k]) ? cornersOf(triangles[k]!).map((corner) => now.get(Number(corner)) ?? corner) : triangles[k]!,
  );
  return [
    ...rowEdits(['terrain', 'triangles'], triangles, renumbered),
    ...follow(values, ['ground', 'triangles'], triangles.length, kept),
  ];
}

/// The edits that belong to setting the value at a path.
export function consequences(values: TomlTable, path: Path, next: TomlValue | undefined): Edit[] {
  const [table, index, key] = path;
  if (table === 'terrain' && path.length === 2 && Array.isArray(next)) {
    if (index === 'section') return consequencesOfSection(values, next);
    if (index === 'vertices') return consequencesOfVertices(values, next);
    return index === 'triangles' ? consequencesOfTriangles(values, next) : [];
  }
  const rows = values[String(table)];
  const row = Array.isArray(rows) && typeof index === 'number' ? rows[index] : undefined;
  if (path.length !== 3 || !isTable(row)) return [];
  const declared = tableOf(String(table));
  if (!declared || !declared.fields.some((field) => field.key === key)) return [];
  const after = next === undefined ? without(row, String(key)) : { ...row, [String(key)]: next };
  return declared.fields.flatMap((field) =>
    row[field.key] !== undefined && isOfOtherWord(field, declared.key, String(key), after)
      ? [{ remove: [table as TableName, index!, field.key] }]
      : [],
  );
}

const without = (row: TomlTable, key: string): TomlTable =>
  Object.fromEntries(Object.entries(row).filter(([other]) => other !== key));

/// Whether a setting applies only to other values of `key` than the row now has.
const isOfOtherWord = ({ needs }: Field, table: string, key: string, row: TomlTable) =>
  needs.some((any) => any.every((one) => one.key === key && one.is && !holds(one, table, row, {})));

const noMaterial = -1;

/// The edits that remove an entry of a list. Removing a material renumbers the materials of triangles; triangles of the
/// removed one have index -1, which the engine reports.
export function removal(values: TomlTable, path: Path): Edit[] {
  const [table, index] = path;
  const edits: Edit[] = [{ remove: path }];
  const triangles = valueIn(values, ['ground', 'triangles']);
  if (table === 'material' && typeof index === 'number' && Array.isArray(triangles)) {
    const moved = triangles.map((number) =>
      typeof number !== 'number' || number < index ? number : number === index ? noMaterial : number - 1,
    );
    edits.push({ set: ['ground', 'triangles'], value: moved });
  }
  return edits;
}
