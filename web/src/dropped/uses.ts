// What a dropped file of a GIS can be in the project.

import type { Model, Point2, Problem } from '../api/types';
import type { Edit, Row } from '../settings/names';
import type { FileKind } from '../settings/fileEndings';

export type Use = 'layer' | 'barrier' | 'collector' | 'release' | 'ground' | 'forest' | 'ask' | 'section' | 'terrain' | 'store';

export interface ReadShape {
  kind: 'line' | 'polygon';
  points: Point2[];
}

export interface Choice {
  use: Use;
  title: string;
  what: string;
}

/// The terrain that the engine builds of a file, or why it does not.
export type Outcome = { terrain: Pick<Model, 'bounds' | 'facets'> } | { problems: Problem[] };
export interface Tried {
  section: Outcome;
  survey: Outcome;
}

/// A table of more vertices than this is hardly a section, and is not triangulated only to be asked about.
export const mostOfSections = 100_000;

/// More lines than this are hardly barriers.
export const mostBarriers = 50;

const counted = (count: number, one: string) => (count === 1 ? `1 ${one}` : `${count} ${one}s`);

const layer: Choice = { use: 'layer', title: 'Reference layer', what: 'drawn over the terrain; changes no result' };
const store: Choice = { use: 'store', title: 'Only store it', what: 'for the forms that choose a file' };
const section: Choice = { use: 'section', title: 'Section (2D)', what: 'the slope itself, in the order of its points' };

/// Whether the points of a section wander over the plan, as those of a survey do. A section's x is the distance along
/// its line.
function isLikelySurvey({ section, survey }: Tried): boolean {
  if ('problems' in section || 'problems' in survey) return false;
  if (section.terrain.facets > mostOfSections) return true;
  const { min, max } = survey.terrain.bounds;
  const length = section.terrain.bounds.max[0] - section.terrain.bounds.min[0];
  return length > 2 * Math.hypot(max[0] - min[0], max[1] - min[1]);
}

/// What a file can be that may be the terrain, the likelier first.
export function terrainChoices(kind: FileKind, tried: Tried): Choice[] {
  const of = kind === 'vector' ? 'contours or breaklines' : 'points';
  const survey: Choice = { use: 'terrain', title: 'Survey (3D)', what: `${of} on plan, joined by triangles` };
  const both = [...('terrain' in tried.section ? [section] : []), ...('terrain' in tried.survey ? [survey] : [])];
  return [...(isLikelySurvey(tried) ? both.reverse() : both), store];
}

/// Why a file is no section, or neither that nor a survey.
export function refusals({ section, survey }: Tried): Problem[] {
  if ('terrain' in section) return [];
  const ofSurvey = 'problems' in survey ? survey.problems : [];
  const isInBoth = ({ text }: Problem) => section.problems.some((one) => one.text === text) && ofSurvey.some((one) => one.text === text);
  const withUse = (use: string) => (problem: Problem) => ({ ...problem, text: `As a ${use}: ${problem.text}` });
  return [
    ...section.problems.filter(isInBoth),
    ...section.problems.filter((problem) => !isInBoth(problem)).map(withUse('section')),
    ...ofSurvey.filter((problem) => !isInBoth(problem)).map(withUse('survey')),
  ];
}

const newTerrain = (what: string): Choice => ({ use: 'terrain', title: 'The terrain', what: `${what}, in place of the present terrain` });

/// What can be chosen for a file beside a terrain. Layers are drawn over one in 3D. `shapes`: the lines and areas in the
/// file, null if it has none or cannot be placed.
export function choicesFor(kind: FileKind, shapes: readonly ReadShape[] | null, { isSection = false, isInSpace = true } = {}): Choice[] {
  if (kind === 'picture') return [layer, store];
  if (kind === 'raster') return [...(isInSpace ? [layer] : []), newTerrain('its values are elevations'), store];
  if (kind === 'mesh') return [newTerrain('its triangles'), store];
  if (kind === 'points') return [newTerrain('its points, joined by triangles'), store];
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
  if (areas > 0) choices.push({ use: 'forest', title: 'A forest', what: `trees in ${counted(areas, 'area')} slow the rocks` });
  if (lines + areas > 0) choices.push({ use: 'ask', title: lines > 0 ? 'A line to ask' : 'An area to ask', what: 'which rocks get there, after a run' });
  if (isSection) choices.push({ ...section, what: 'a slope along this line, in place of the present terrain' });
  if (lines > 0) choices.push(newTerrain('contours or breaklines of a survey'));
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

/// Appends a forest over the file's areas; how dense and how high it is, the user says.
export const forestEdits = (file: string, taken: readonly string[]): Edit[] => [
  { append: ['forest'], value: { name: freeName(stemOf(file), taken), polygons: file } },
];

export const layerEdits = (file: string, taken: readonly string[]): Edit[] => [{ append: ['layer'], value: { name: freeName(stemOf(file), taken), file } }];
