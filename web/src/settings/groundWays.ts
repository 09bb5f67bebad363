// The ways to assign materials to the ground.

import type { Edit, KeyOf, Row } from './names';
import type { TomlValue } from '../toml/format';

export interface GroundWay {
  name: string;
  title: string;
  keys: KeyOf<'ground'>[];
}

export const groundWays: GroundWay[] = [
  { name: 'one', title: 'One material everywhere', keys: [] },
  { name: 'segments', title: 'By segments of the section', keys: ['segments'] },
  { name: 'triangles', title: 'By triangles, picked in the view', keys: ['triangles'] },
  { name: 'polygons', title: 'By polygons of a file', keys: ['polygons', 'layer', 'attribute', 'values'] },
  { name: 'raster', title: 'By a raster of classes', keys: ['raster', 'classes'] },
];

export const wayOf = (ground: Row<'ground'>): GroundWay =>
  groundWays.find(({ keys }) => keys[0] !== undefined && ground[keys[0]] !== undefined) ?? groundWays[0]!;

/// The ways that a kind of terrain allows.
export function waysFor(terrainKind: string): GroundWay[] {
  const names: Record<string, string[]> = {
    section: ['one', 'segments'],
    raster: ['one', 'polygons', 'raster'],
  };
  const allowed = names[terrainKind] ?? ['one', 'triangles', 'polygons', 'raster'];
  return groundWays.filter(({ name }) => allowed.includes(name));
}

/// The edits that change to a way: settings of the others are removed, and a default is added if there are several
/// materials.
export function changeWay(way: GroundWay, ground: Row<'ground'>, materials: readonly string[]): Edit[] {
  const removes = groundWays
    .flatMap(({ name, keys }) => (name === way.name ? [] : keys))
    .filter((key) => ground[key] !== undefined);
  const needsDefault = ground.default === undefined && materials.length > 1 && materials[0] !== undefined;
  return [
    ...removes.map((key) => ({ remove: ['ground', key] as const })),
    ...(needsDefault ? [{ set: ['ground', 'default'] as const, value: materials[0]! }] : []),
  ];
}

/// The materials of segments (names) or triangles (indices) with one changed. A list that is too short is filled with
/// `standard`.
export function materialsWith<Name extends TomlValue>(
  given: unknown,
  count: number,
  part: number,
  material: Name,
  standard: Name,
): TomlValue[] {
  const list = Array.isArray(given) ? (given as TomlValue[]) : [];
  return Array.from({ length: Math.max(count, list.length) }, (_, k) =>
    k === part ? material : (list[k] ?? standard),
  );
}
