// The terrain, its files, location and size, and the assignment of materials.

import type { Setting, Settings, TerrainSummary } from '../archive/summary';
import * as d3 from '../figures/d3';
import { crsText } from './crs';
import { count, isList, isNumber, measured, number, settingText, unitOf, wordsOf } from './format';
import { listOf, materialsOf, nameIn, tableOf, type Run } from './run';
import { applies } from './settingEffects';
import type { BodyCell } from './tables';

type NamedText = [name: string | BodyCell, text: string];

// Columns, rows and spacing of a raster's nodes, from the triangle count of the summary: two per cell. Null if square
// cells would not fill the terrain.
function nodesOf({ bounds: [low, high] = [], kind, triangles }: TerrainSummary) {
  if (kind !== 'raster' || !low || !high || !isNumber(triangles)) return null;
  const [wide, tall, squares] = [high[0] - low[0], high[1] - low[1], triangles / 2];
  const [across, along] = [Math.round(Math.sqrt((squares * wide) / tall)), Math.round(Math.sqrt((squares * tall) / wide))];
  if (across * along !== squares) return null;
  return { columns: across + 1, rows: along + 1, dx: wide / across, dy: tall / along };
}

const rangeText = (low: number, high: number) => `${number(low, 8)} to ${number(high, 8)} m (${number(high - low, 5)} m)`;
const extentText = (values: readonly number[]) => {
  const [low, high] = d3.extent(values);
  return low === undefined || high === undefined ? '–' : rangeText(low, high);
};

// The settings of the terrain, except coordinates and settings without an effect.
function terrainSettings(run: Run): NamedText[] {
  const given = tableOf(run, 'terrain');
  const ofRotation = given.rotate_deg ? [] : ['rotate_deg', 'rotate_about'];
  const unwanted = new Set(['section', 'vertices', 'triangles', 'polylines', 'crs', ...ofRotation]);
  return Object.entries(given)
    .filter(([key]) => !unwanted.has(key) && applies(run, 'terrain', key, given))
    .map(([key, value]) => [{ text: wordsOf(key), unit: unitOf(key) }, settingText(value)]);
}

const kinds: Record<string, string> = { section: 'Section, 2D', mesh: 'Triangle mesh, 3D', raster: 'Elevation raster, 3D' };

function systemText(run: Run): string {
  if (run.terrain.crs_wkt) return crsText(run.terrain.crs_wkt);
  return tableOf(run, 'terrain').crs === 'local' ? 'local, in metres' : 'unknown';
}

function sectionRows(section: readonly (readonly [number, number])[]): NamedText[] {
  return [
    ['Vertices', number(section.length)],
    ['Extent in x', extentText(section.map(([x]) => x))],
    ['Extent in z', extentText(section.map(([, z]) => z))],
  ];
}

function nodeRows(terrain: TerrainSummary): NamedText[] {
  const nodes = nodesOf(terrain);
  if (!nodes) return [];
  const [dx, dy] = [number(nodes.dx, 4), number(nodes.dy, 4)];
  return [
    ['Nodes', `${number(nodes.columns)} × ${number(nodes.rows)}`],
    [{ text: 'Cell size', unit: 'm' }, dx === dy ? dx : `${dx} × ${dy}`],
  ];
}

export function terrainRows(run: Run): NamedText[] {
  const { isSection, terrain, summary } = run;
  const { kind, section, bounds: [low, high] = [], triangles } = terrain;
  const axes = [0, 1, 2] as const;
  const extents = low && high ? axes.map((axis): NamedText => [`Extent in ${'xyz'[axis]}`, rangeText(low[axis], high[axis])]) : [];
  const datum = summary.energy_datum_m;
  return [
    ...(kind ? [['Kind', kinds[kind] ?? kind] satisfies NamedText] : []),
    ...terrainSettings(run),
    ...(isSection && section ? sectionRows(section) : []),
    ...(!isSection && kind ? [['Coordinate system', systemText(run)] satisfies NamedText] : []),
    ...extents,
    ...nodeRows(terrain),
    ...(isNumber(triangles) ? [['Triangles', number(triangles)] satisfies NamedText] : []),
    ...(isNumber(datum) ? [['Potential energy is zero at z', `${measured(datum, 5)} m`] satisfies NamedText] : []),
  ];
}

// Names of the user stay as they are.
const nameText = (value: Setting) => (typeof value === 'string' ? value : settingText(value));

// Merges adjacent segments of the same material: "Segments 1 to 6".
function segmentRows(segments: readonly Setting[]): NamedText[] {
  const parts: { name: Setting; from: number; to: number }[] = [];
  segments.forEach((name, k) => {
    const last = parts.at(-1);
    if (last && last.name === name) last.to = k + 1;
    else parts.push({ name, from: k + 1, to: k + 1 });
  });
  return parts.map(({ name, from, to }) => [from === to ? `Segment ${from}` : `Segments ${from} to ${to}`, nameText(name)]);
}

const row = (label: string, value: Setting): NamedText[] => (value === undefined ? [] : [[label, settingText(value)]]);
const isTable = (value: Setting): value is Settings => typeof value === 'object' && value !== null && !isList(value);
// A row for each key of a table in a table.
const rowsOf = (given: Setting, labelOf: (key: string) => string) =>
  isTable(given) ? Object.entries(given).flatMap(([key, value]) => row(labelOf(key), value)) : [];

function areaRow({ material, polygon, ...area }: Settings): NamedText {
  const place = isList(polygon) ? `, within ${count(polygon.length, 'corner')} drawn on plan` : '';
  return [`Area ${nameIn(area)}`, `${nameText(material)}${place}`];
}

export function groundRows(run: Run): NamedText[] {
  const { default: usual, segments, triangles, raster, classes, polygons, layer, attribute, values } = tableOf(run, 'ground');
  const [only, ...others] = materialsOf(run);
  return [
    ...row('Default', usual ?? (only && others.length === 0 ? nameIn(only) : undefined)),
    ...(isList(segments) ? segmentRows(segments) : row('Segments', segments)),
    ...row('Materials of triangles', isList(triangles) ? `${number(triangles.length)} entries` : triangles),
    ...row('Raster of classes', raster),
    ...rowsOf(classes, (value) => `Class ${value}`),
    ...row('Polygons', polygons),
    ...row('Layer', layer),
    ...row('Attribute of the material', attribute),
    ...rowsOf(values, (value) => `${typeof attribute === 'string' && attribute ? attribute : 'Value'} = ${value}`),
    ...listOf(run, 'area').map(areaRow),
  ];
}

/// The terrain's files, if any.
export function terrainFile(run: Run): string {
  const { raster, mesh, points, lines, polygons } = tableOf(run, 'terrain');
  return [raster || mesh || points, lines, polygons].filter((file) => typeof file === 'string').join(', ');
}
