// What else changes when a value does, in the same step: keys that mean nothing beside a new kind, numbers of what
// moves.

import type { Edit, Path } from '../toml/edit';
import type { TomlTable, TomlValue } from '../toml/format';
import { isTable, valueIn } from './tables';

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

const noMaterial = -1;

/// The edits that take an entry out of a list. Triangles call materials by their numbers: those of a later material
/// have it by its new number, those of the one that goes have none, which the engine complains of.
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
