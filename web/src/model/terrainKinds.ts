// The ways to give a terrain, and the edits that change from one to another.

import type { Edit } from '../toml/edit';
import type { TomlTable, TomlValue } from '../toml/format';
import { applies } from './applies';
import { fieldOf } from './settings';

export interface TerrainKind {
  name: string;
  title: string;
  what: string;
  /// The keys of `[terrain]` that make it.
  keys: string[];
  /// What begins it, where that is not a file.
  first?: TomlValue;
}

export const terrainKinds: TerrainKind[] = [
  {
    name: 'section',
    title: 'Section',
    what: 'A slope in section, drawn, typed or pasted; 2D, or extruded to a width',
    keys: ['section'],
    first: [],
  },
  {
    name: 'raster',
    title: 'Raster of elevations',
    what: 'A GeoTIFF or another grid in projected metres',
    keys: ['raster'],
  },
  { name: 'mesh', title: 'Triangle mesh', what: 'A file of triangles: .obj, .stl or .ply', keys: ['mesh'] },
  {
    name: 'survey',
    title: 'Survey',
    what: 'Points (.csv, .xyz, .las) and contours or breaklines, triangulated',
    keys: ['points', 'lines'],
  },
  {
    name: 'polylines',
    title: 'Closed polylines',
    what: 'Drawn, typed or pasted; each becomes a polygon, cut into triangles',
    keys: ['polylines'],
    first: [],
  },
  {
    name: 'polygons',
    title: 'Polygons of a file',
    what: 'Closed lines or polygons with heights (.dxf, .gpkg, ...)',
    keys: ['polygons'],
  },
  { name: 'triangles', title: 'Vertices and triangles', what: 'A mesh as two tables', keys: ['vertices', 'triangles'] },
];

export const kindOf = (terrain: TomlTable): TerrainKind | undefined =>
  terrainKinds.find(({ keys }) => keys.some((key) => terrain[key] !== undefined));

/// The edits that make a terrain of another kind; with a value, by its first key.
export function changeTo(
  kind: TerrainKind,
  terrain: TomlTable,
  value: TomlValue | undefined = kind.first,
  key = kind.keys[0]!,
): Edit[] {
  const others = new Set(terrainKinds.flatMap(({ keys }) => keys).filter((other) => !kind.keys.includes(other)));
  const next: TomlTable = Object.fromEntries([
    ...Object.entries(terrain).filter(([other]) => !others.has(other)),
    ...(kind.keys.some((own) => terrain[own] !== undefined) ? [] : [[key, value ?? '']]),
  ]);
  const means = (other: string, row: TomlTable) =>
    applies(fieldOf('terrain', other)?.needs ?? [], 'terrain', row, { terrain: row });
  const removes = Object.keys(terrain).filter(
    (other) => others.has(other) || (means(other, terrain) && !means(other, next)),
  );
  return [
    ...removes.map((other) => ({ remove: ['terrain', other] })),
    ...(value !== undefined && terrain[key] === undefined ? [{ set: ['terrain', key], value }] : []),
  ];
}
