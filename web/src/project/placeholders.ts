// Shows the terrain of a project that cannot run yet: entries with problems are removed from the text, and placeholders
// are added for missing ones.

import type { Model, Problem } from '../api/types';
import { pathOf, type Edit, type Row, type TableName } from '../settings/names';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import type { TomlValue } from '../toml/format';
import { isTable } from '../settings/tables';

const name = 'placeholder for a seeder';

/// The edit that removes the cause of a problem: an entry of a list, or a key of another table.
function removalFor(problem: Problem): Edit | null {
  const path = pathOf(problem.path);
  const [table, index] = path;
  if (problem.severity !== 'error' || problem.path === '' || table === undefined) return null;
  if (table === 'material') return path.length > 2 ? { remove: path.slice(0, 3) } : null;
  if (typeof index === 'number') return { remove: [table, index] };
  return { remove: path.length > 1 ? path.slice(0, 2) : path };
}

/// A position on the terrain: the first vertex of a section, or the middle of the extent that the engine reports.
function positionOn(terrain: Row<'terrain'>, problems: readonly Problem[]): TomlValue[] {
  const { section } = terrain;
  const isFlat = section !== undefined && terrain.width_m === undefined;
  if (isFlat && Array.isArray(section) && Array.isArray(section[0])) return section[0];
  if (isFlat) {
    const ends = problems.map(({ why }) => /x = (\S+) to ([^\s)]+)/.exec(why)?.slice(1).map(Number));
    const [left, right] = ends.find((pair) => pair?.every(Number.isFinite)) ?? [0, 0];
    return [(left! + right!) / 2, 'surface'];
  }
  const extents = problems.map(({ why }) =>
    /x = (\S+) to (\S+), y = (\S+) to ([^\s)]+)/.exec(why)?.slice(1).map(Number),
  );
  const [west, east, south, north] = extents.find((extent) => extent?.every(Number.isFinite)) ?? [0, 0, 0, 0];
  return [(west! + east!) / 2, (south! + north!) / 2, 0];
}

const isOfTerrain = ({ path }: Problem) => path === 'terrain' || path.startsWith('terrain.');

/// The problems of a text, and problems of its terrain that were only found with placeholders. The latter have no line
/// numbers, because the lines of that text are not those of the project.
export function withTerrainProblems(found: readonly Problem[], withPlaceholders: readonly Problem[]): Problem[] {
  const isNew = ({ path, what }: Problem) => !found.some((known) => known.path === path && known.what === what);
  const terrain = withPlaceholders.filter((problem) => isOfTerrain(problem) && isNew(problem));
  const withoutLine = (problem: Problem) => ({
    ...problem,
    line: 0,
    text: problem.text.replace(`${problem.file}:${problem.line}:`, `${problem.file}:`),
  });
  return [...found, ...terrain.map(withoutLine)];
}

/// A text that may build; null if the terrain itself has errors.
export function withPlaceholders(text: string, problems: readonly Problem[]): string | null {
  try {
    const { terrain } = valuesOf(text);
    const errors = problems.filter(({ severity }) => severity === 'error');
    if (!isTable(terrain) || errors.some(isOfTerrain)) return null;
    const removes = errors.flatMap((problem) => removalFor(problem) ?? []);
    // From the last one on, so that indices of entries stay valid.
    const inOrder = [...new Map(removes.map((edit) => [JSON.stringify(edit), edit])).values()].sort((a, b) =>
      JSON.stringify(b).localeCompare(JSON.stringify(a), 'en', { numeric: true }),
    );
    let next = edited(text, inOrder);
    const left = valuesOf(next);
    const isNone = (key: TableName) => !Array.isArray(left[key]) || left[key].length === 0;
    const seeder: Row<'seeder'> = { name, position: positionOn(terrain, errors), rocks: 1, mass_kg: 1000 };
    if (isNone('material')) next = edited(next, [{ append: ['material'], value: { name: 'Ground' } }]);
    if (isNone('seeder')) next = edited(next, [{ append: ['seeder'], value: seeder }]);
    return next === text ? null : next;
  } catch {
    return null;
  }
}

/// The model without placeholders.
export function withoutPlaceholders(model: Model): Model {
  const seeders = model.seeders.filter((seeder) => seeder.name !== name);
  return seeders.length === model.seeders.length ? model : { ...model, seeders, rocks: model.rocks - 1 };
}
