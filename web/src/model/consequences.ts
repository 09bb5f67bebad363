// What else changes when a value does, in the same step: who names a thing that is renamed, keys that mean nothing
// beside a new kind.

import type { Edit, Path } from '../toml/edit';
import type { TomlTable, TomlValue } from '../toml/format';

export const isTable = (value: unknown): value is TomlTable =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/// Every place below a path where a name stands.
function uses(value: TomlValue | undefined, name: string, path: Path): Path[] {
  if (value === name) return [path];
  if (Array.isArray(value)) return value.flatMap((part, k) => uses(part, name, [...path, k]));
  return isTable(value) ? Object.entries(value).flatMap(([key, part]) => uses(part, name, [...path, key])) : [];
}

const namingKeys: Record<string, Path[]> = {
  material: [
    ['ground', 'default'],
    ['ground', 'segments'],
    ['ground', 'classes'],
    ['ground', 'values'],
  ],
  barrier: [['design', 'lines']],
  collector: [
    ['design', 'lines'],
    ['design', 'protect'],
  ],
};

const valueIn = (values: TomlTable, path: Path) =>
  path.reduce<TomlValue | undefined>(
    (at, part) => (isTable(at) ? at[String(part)] : Array.isArray(at) ? at[Number(part)] : undefined),
    values,
  );

/// Where entries of a list are called by their names.
function namingPlaces(values: TomlTable, table: string): Path[] {
  const areas = table === 'material' && Array.isArray(values.area) ? values.area : [];
  return [...(namingKeys[table] ?? []), ...areas.map((_, k) => ['area', k, 'material'])];
}

const placesOf: Record<string, string[]> = {
  point: ['position'],
  line: ['points', 'lines', 'layer', 'source_attribute'],
  polygon: [
    'polygon',
    'polygons',
    'layer',
    'source_attribute',
    'min_slope_deg',
    'max_slope_deg',
    'mask',
    'mask_value',
    'cell_m',
    'place',
    'rocks_per_cell',
  ],
  raster: ['min_slope_deg', 'max_slope_deg', 'mask', 'mask_value', 'cell_m', 'place', 'rocks_per_cell'],
};

/// The edits that belong to setting the value at a path.
export function consequences(values: TomlTable, path: Path, next: TomlValue | undefined): Edit[] {
  const [table, index, key] = path;
  const rows = values[String(table)];
  const row = Array.isArray(rows) && typeof index === 'number' ? rows[index] : undefined;
  if (path.length !== 3 || !isTable(row)) return [];
  if (key === 'name' && typeof next === 'string' && typeof row.name === 'string') {
    const old = row.name;
    return namingPlaces(values, String(table))
      .flatMap((place) => uses(valueIn(values, place), old, place))
      .map((set) => ({ set, value: next }));
  }
  if (table === 'seeder' && key === 'type') {
    const kept = placesOf[String(next ?? 'point')] ?? [];
    const others = new Set(
      Object.values(placesOf)
        .flat()
        .filter((place) => !kept.includes(place)),
    );
    return Object.keys(row).flatMap((place) => (others.has(place) ? [{ remove: ['seeder', index!, place] }] : []));
  }
  return [];
}

/// The edits that take an entry out of a list: triangles that had a material with a larger number have it by its new one.
export function removal(values: TomlTable, path: Path): Edit[] {
  const [table, index] = path;
  const edits: Edit[] = [{ remove: path }];
  const triangles = valueIn(values, ['ground', 'triangles']);
  if (table === 'material' && typeof index === 'number' && Array.isArray(triangles)) {
    const moved = triangles.map((number) =>
      typeof number === 'number' && number > index ? number - 1 : number === index ? 0 : number,
    );
    edits.push({ set: ['ground', 'triangles'], value: moved });
  }
  return edits;
}
