// Blocks and releases of a run in few words for a sheet, from the project in its summary.

import { entriesIn } from '../archive/summary';
import type { Echo } from './sheetInputs';
import { drawnText, isGiven } from './sheetInputs';
import { wordText } from '../settings/words';

const joined = (parts: readonly (string | false | null | undefined)[]) => parts.filter(Boolean).join(', ');

const shapeFacts: readonly (readonly [string, string])[] = [
  ['b_over_a', 'b/a'],
  ['c_over_b', 'c/b'],
  ['axes_m', 'axes [m]'],
  ['solid', 'solid'],
  ['sides', 'sides'],
  ['scan', 'scan'],
  ['of', 'one of'],
];
const valueText = (value: unknown): string => (Array.isArray(value) ? value.map(valueText).join(', ') : drawnText(value));

/// "slab (b/a 0.8, c/b 0.4)"; a word of the program as it is.
export function shapeText(project: Echo, name: string): string {
  const own = entriesIn(project, 'shape').find((each) => each.name === name);
  if (!own) return wordText(name);
  const facts = shapeFacts.filter(([key]) => isGiven(own[key]) && own[key] !== 'none').map(([key, title]) => `${title} ${valueText(own[key])}`);
  return facts.length > 0 ? `${name} (${facts.join('; ')})` : name;
}

/// The shape of a seeder's blocks, as its model takes it.
export function blockShape(project: Echo, seeder: Echo): string {
  const model = (project.analysis as Echo | undefined)?.model;
  if (model === 'rigid_body') return shapeText(project, String(seeder.shape ?? 'sphere'));
  return model === 'rigid_sphere' ? 'sphere' : 'none';
}

const pointText = (place: unknown): string => (Array.isArray(place) ? `(${place.map(valueText).join(', ')})` : '');

/// Where the rocks of a seeder start, and how fast: "cells of cliffs.geojson, steeper than 55°, 2 m above the ground".
export function releaseText(seeder: Echo): string {
  const { type, polygons, polygon, lines, table, points, position, mask } = seeder;
  const file = [polygons, lines, table].find((each) => typeof each === 'string');
  const where: Record<string, string> = {
    point: `at ${pointText(position)}`,
    line: file ? `along lines of ${file}` : `along a line of ${Array.isArray(points) ? points.length : 0} points`,
    polygon: `in cells ${file ? `of ${file}` : `of a polygon with ${Array.isArray(polygon) ? polygon.length : 0} corners`}`,
    raster: 'in cells of the terrain',
    table: `at the rows of ${file ?? 'a table'}`,
  };
  const number = (key: string) => (isGiven(seeder[key]) ? drawnText(seeder[key]) : null);
  const speed = [seeder.speed_m_s, seeder.horizontal_velocity_m_s].find(isGiven);
  return joined([
    where[String(type)] ?? wordText(String(type)),
    number('min_slope_deg') && `steeper than ${number('min_slope_deg')}°`,
    number('max_slope_deg') && `flatter than ${number('max_slope_deg')}°`,
    typeof mask === 'string' && `mask ${mask}`,
    number('height_above_m') && number('height_above_m') !== '0' && `${number('height_above_m')} m above the ground`,
    speed !== undefined && drawnText(speed) !== '0' && drawnText(speed, 'm/s'),
  ]);
}
