// Whether a file can be the terrain, as the engine says: it builds a project of the file alone.

import type { Problem } from '../api/types';
import type { KeyOf } from '../settings/names';
import { modelOf } from '../project/model';
import { pairText } from '../toml/format';
import { mostOfSections, type Outcome, type Tried } from './uses';

const isOfTerrain = ({ path, severity }: Problem) => severity === 'error' && (path === 'terrain' || path.startsWith('terrain.'));

/// Without the place in a project that nobody sees, and without the key if the file is named.
function ofFile(problem: Problem, key: string, file: string): Problem {
  const text = problem.text.replace(/^.*?\[terrain\]: /, '');
  return { ...problem, text: text.startsWith(`${key} ${file}`) ? text.slice(key.length + 1) : text };
}

/// `file` is named as in the project.
export async function triedAs(key: KeyOf<'terrain'>, file: string, project: string): Promise<Outcome> {
  const { model, found } = await modelOf(project, `[terrain]\n${pairText(key, file)}\n`);
  if (model) return { terrain: model };
  const own = found.filter(isOfTerrain);
  return { problems: (own.length > 0 ? own : found).map((problem) => ofFile(problem, key, file)) };
}

/// As a section and, by its key, as a survey.
export async function triedBoth(file: string, project: string, surveyKey: KeyOf<'terrain'>): Promise<Tried> {
  const section = await triedAs('section', file, project);
  const isLong = 'terrain' in section && section.terrain.facets > mostOfSections;
  return { section, survey: isLong ? section : await triedAs(surveyKey, file, project) };
}
