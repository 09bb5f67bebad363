// The terrain, its files, location and size, and the assignment of materials.

import * as d3 from '../figures/d3';
import { crsText } from './crs';
import { count, isNumber, measured, number, settingText, unitOf, wordsOf } from './format';
import { listOf, materialsOf } from './run';
import { applies } from './settingEffects';

// Columns, rows and spacing of a raster's nodes, from the triangle count of the summary: two per cell. Null if square
// cells would not fill the terrain.
function nodesOf(terrain) {
  const [low, high] = terrain.bounds || [];
  if (terrain.kind !== 'raster' || !low || !isNumber(terrain.triangles)) return null;
  const wide = high[0] - low[0], tall = high[1] - low[1], squares = terrain.triangles / 2;
  const across = Math.round(Math.sqrt(squares * wide / tall)), along = Math.round(Math.sqrt(squares * tall / wide));
  if (across * along !== squares) return null;
  return {columns: across + 1, rows: along + 1, dx: wide / across, dy: tall / along};
}

const rangeOf = (low, high) => `${number(low, 8)} to ${number(high, 8)} m (${number(high - low, 5)} m)`;

// The settings of the terrain, except coordinates and settings without an effect.
function terrainSettings(run) {
  const given = run.project.terrain || {};
  const ofRotation = given.rotate_deg ? [] : ['rotate_deg', 'rotate_about'];
  const unwanted = new Set(['section', 'vertices', 'triangles', 'polylines', 'crs', ...ofRotation]);
  return Object.entries(given).filter(([key]) => !unwanted.has(key) && applies(run, 'terrain', key, given))
    .map(([key, value]) => [{text: wordsOf(key), unit: unitOf(key)}, settingText(value)]);
}

export function terrainRows(run) {
  const {terrain} = run;
  const kinds = {section: 'Section, 2D', mesh: 'Triangle mesh, 3D', raster: 'Elevation raster, 3D'};
  const rows = terrain.kind ? [['Kind', kinds[terrain.kind] || terrain.kind]] : [];
  rows.push(...terrainSettings(run));
  if (run.isSection && Array.isArray(terrain.section)) {
    rows.push(['Vertices', number(terrain.section.length)],
      ['Extent in x', rangeOf(...d3.extent(terrain.section, (p) => p[0]))], ['Extent in z', rangeOf(...d3.extent(terrain.section, (p) => p[1]))]);
  }
  if (!run.isSection && terrain.kind) {
    const local = (run.project.terrain || {}).crs === 'local';
    rows.push(['Coordinate system', terrain.crs_wkt ? crsText(terrain.crs_wkt) : local ? 'local, in metres' : 'unknown']);
  }
  if (Array.isArray(terrain.bounds)) {
    const [low, high] = terrain.bounds;
    ['x', 'y', 'z'].forEach((name, i) => rows.push([`Extent in ${name}`, rangeOf(low[i], high[i])]));
  }
  const nodes = nodesOf(terrain);
  if (nodes) {
    const spacing = [number(nodes.dx, 4), number(nodes.dy, 4)];
    rows.push(['Nodes', `${number(nodes.columns)} × ${number(nodes.rows)}`],
      [{text: 'Cell size', unit: 'm'}, spacing[0] === spacing[1] ? spacing[0] : spacing.join(' × ')]);
  }
  if (isNumber(terrain.triangles)) rows.push(['Triangles', number(terrain.triangles)]);
  if (isNumber(run.summary.energy_datum_m)) rows.push(['Potential energy is zero at z', `${measured(run.summary.energy_datum_m, 5)} m`]);
  return rows;
}

// Merges adjacent segments of the same material: "Segments 1 to 6".
function segmentRows(segments) {
  const rows = [];
  segments.forEach((name, i) => {
    const last = rows[rows.length - 1];
    if (last && last.name === name) last.to = i + 1;
    else rows.push({name, from: i + 1, to: i + 1});
  });
  return rows.map(({name, from, to}) => [from === to ? `Segment ${from}` : `Segments ${from} to ${to}`, name]);
}

export function groundRows(run) {
  const {default: fallback, segments, triangles, raster, classes, polygons, layer, attribute, values} = run.project.ground || {};
  const rows = [];
  const row = (label, value) => { if (value !== undefined) rows.push([label, settingText(value)]); };
  row('Default', fallback ?? (materialsOf(run).length === 1 ? materialsOf(run)[0].name : undefined));
  if (Array.isArray(segments)) rows.push(...segmentRows(segments));
  else row('Segments', segments);
  if (triangles !== undefined) row('Materials of triangles', Array.isArray(triangles) ? `${number(triangles.length)} entries` : triangles);
  row('Raster of classes', raster);
  for (const [value, name] of Object.entries(classes || {})) row(`Class ${value}`, name);
  row('Polygons', polygons);
  row('Layer', layer);
  row('Attribute of the material', attribute);
  for (const [value, name] of Object.entries(values || {})) row(`${attribute || 'Value'} = ${value}`, name);
  for (const {name, material, polygon} of listOf(run, 'area')) {
    row(`Area ${name}`, material + (Array.isArray(polygon) ? `, within ${count(polygon.length, 'corner')} drawn on plan` : ''));
  }
  return rows;
}

// The terrain's files, if any.
export function terrainFile(run) {
  const {raster, mesh, points, lines, polygons} = run.project.terrain || {};
  return [raster || mesh || points, lines, polygons].filter((file) => typeof file === 'string').join(', ');
}
