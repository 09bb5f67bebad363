// The kinds of terrain, and the edits that change from one to another.

import type { Edit, KeyOf, Row } from './names';
import type { TomlTable, TomlValue } from '../toml/format';
import { applies } from './applies';
import { endingsOf } from './fileEndings';
import { fieldOf } from './declared';

export interface TerrainKind {
  name: string;
  title: string;
  what: string;
  /// The keys of `[terrain]` that define it.
  keys: KeyOf<'terrain'>[];
  /// The initial value of the first key, unless it is a file.
  first?: TomlValue;
}

export const terrainKinds: TerrainKind[] = [
  {
    name: 'section',
    title: 'Section',
    what: 'A slope in section, drawn, typed, pasted or from a file; 2D, or extruded to a width',
    keys: ['section'],
    first: [],
  },
  {
    name: 'raster',
    title: 'Raster of elevations',
    what: 'A GeoTIFF or another grid in projected metres',
    keys: ['raster'],
  },
  { name: 'mesh', title: 'Triangle mesh', what: `A file of triangles: ${endingsOf('mesh')}`, keys: ['mesh'] },
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

export const kindOf = (terrain: Row<'terrain'>): TerrainKind | undefined =>
  terrainKinds.find(({ keys }) => keys.some((key) => terrain[key] !== undefined));

/// The edits that change the terrain to a kind. `value` is the initial value of `key`.
export function changeTo(
  kind: TerrainKind,
  terrain: Row<'terrain'>,
  value: TomlValue | undefined = kind.first,
  key = kind.keys[0]!,
): Edit[] {
  const others = new Set(terrainKinds.flatMap(({ keys }) => keys).filter((other) => !kind.keys.includes(other)));
  const given = Object.entries(terrain) as [KeyOf<'terrain'>, TomlValue][];
  const next: TomlTable = Object.fromEntries([
    ...given.filter(([other]) => !others.has(other)),
    ...(kind.keys.some((own) => terrain[own] !== undefined) ? [] : [[key, value ?? '']]),
  ]);
  const appliesIn = (other: string, row: TomlTable) =>
    applies(fieldOf('terrain', other)?.needs ?? [], 'terrain', row, { terrain: row });
  const before: TomlTable = Object.fromEntries(given);
  const removes = given
    .map(([other]) => other)
    .filter((other) => others.has(other) || (appliesIn(other, before) && !appliesIn(other, next)));
  return [
    ...removes.map((other) => ({ remove: ['terrain', other] as const })),
    ...(value !== undefined && terrain[key] === undefined ? [{ set: ['terrain', key] as const, value }] : []),
  ];
}
