// What a dropped file of a GIS can be in the project.

import type { Point2 } from '../api/types';
import type { Edit, Row } from '../model/names';
import type { FileKind } from '../model/fileEndings';

export type Use = 'layer' | 'barrier' | 'collector' | 'release' | 'ground' | 'ask' | 'terrain' | 'store';

export interface ReadShape {
  kind: 'line' | 'polygon';
  points: Point2[];
}

export interface Choice {
  use: Use;
  title: string;
  what: string;
}

/// More lines than this are hardly barriers.
export const mostBarriers = 50;

const counted = (count: number, one: string) => (count === 1 ? `1 ${one}` : `${count} ${one}s`);

/// What can be chosen for a file; `shapes`: the lines and areas in it, null if it has none or cannot be placed.
export function choicesFor(kind: FileKind, shapes: readonly ReadShape[] | null): Choice[] {
  const layer: Choice = { use: 'layer', title: 'Reference layer', what: 'drawn over the terrain; changes no result' };
  const store: Choice = { use: 'store', title: 'Only store it', what: 'for the forms that choose a file' };
  if (kind === 'picture') return [layer, store];
  if (kind === 'raster') return [layer, { use: 'terrain', title: 'The terrain', what: 'its values are elevations, and replace the present terrain' }, store];
  const lines = shapes?.filter((shape) => shape.kind === 'line').length ?? 0;
  const areas = shapes?.filter((shape) => shape.kind === 'polygon').length ?? 0;
  const choices: Choice[] = [layer];
  if (lines > 0 && lines <= mostBarriers)
    choices.push(
      { use: 'barrier', title: lines === 1 ? 'A barrier' : `${lines} barriers`, what: `along ${counted(lines, 'line')}` },
      { use: 'collector', title: lines === 1 ? 'A collector' : `${lines} collectors`, what: 'lines that count rocks and stop none' },
    );
  if (areas > 0) choices.push({ use: 'release', title: 'Release areas', what: `rocks start from the cells of ${counted(areas, 'area')}` });
  else if (lines > 0) choices.push({ use: 'release', title: 'Release lines', what: `rocks start along ${counted(lines, 'line')}` });
  if (areas > 0) choices.push({ use: 'ground', title: 'Ground', what: 'materials by an attribute of its areas' });
  if (lines + areas > 0) choices.push({ use: 'ask', title: lines > 0 ? 'A line to ask' : 'An area to ask', what: 'which rocks get there, after a run' });
  if (lines > 0) choices.push({ use: 'terrain', title: 'The terrain', what: 'contours or breaklines of a survey, in place of the present terrain' });
  return [...choices, store];
}

/// The file's name without folder and ending.
export const stemOf = (file: string) => file.replace(/^.*\//, '').replace(/\.[^.]*$/, '');

/// An unused name: the wanted one, or with a number.
export function freeName(wanted: string, taken: readonly string[]): string {
  const lower = new Set(taken.map((name) => name.toLowerCase()));
  if (!lower.has(wanted.toLowerCase())) return wanted;
  for (let number = 2; ; ++number) if (!lower.has(`${wanted} ${number}`.toLowerCase())) return `${wanted} ${number}`;
}

/// Coordinates to the centimetre.
const toCentimetres = ([x, y]: Point2): Point2 => [Math.round(100 * x) / 100, Math.round(100 * y) / 100];

/// Appends a barrier or collector along each line.
export function barrierEdits(use: 'barrier' | 'collector', file: string, shapes: readonly ReadShape[], taken: readonly string[]): Edit[] {
  const names = [...taken];
  return shapes
    .filter(({ kind }) => kind === 'line')
    .map(({ points }) => {
      const name = freeName(stemOf(file), names);
      names.push(name);
      const value: Row<'barrier'> = { name, line: points.map(toCentimetres), height_m: 3 };
      return { append: [use], value };
    });
}

/// Appends the seeder of the file's areas, or else of its lines.
export function releaseEdits(file: string, shapes: readonly ReadShape[], taken: readonly string[]): Edit[] {
  const name = freeName(stemOf(file), taken);
  const hasAreas = shapes.some(({ kind }) => kind === 'polygon');
  const where: Row<'seeder'> = hasAreas ? { type: 'polygon', polygons: file } : { type: 'line', lines: file };
  return [{ append: ['seeder'], value: { name, ...where, rocks: 1000 } }];
}

export const layerEdits = (file: string, taken: readonly string[]): Edit[] => [{ append: ['layer'], value: { name: freeName(stemOf(file), taken), file } }];
