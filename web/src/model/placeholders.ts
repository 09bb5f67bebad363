// While a project cannot run yet, its terrain can be shown all the same: a text without what has problems, and
// with something in the place of what is missing.

import type { Model, Problem } from '../api/types';
import { pathOf, type Edit, type Row, type TableName } from './names';
import { edited, valuesOf } from '../toml/edit';
import type { TomlValue } from '../toml/format';
import { isTable } from './tables';

const name = 'stands in for a seeder';

/// What is taken out because of a problem: an entry of a list as a whole, a key of another table.
function removalFor(problem: Problem): Edit | null {
  const path = pathOf(problem.path);
  const [table, index] = path;
  if (problem.severity !== 'error' || problem.path === '' || table === undefined) return null;
  if (table === 'material') return path.length > 2 ? { remove: path.slice(0, 3) } : null;
  if (typeof index === 'number') return { remove: [table, index] };
  return { remove: path.length > 1 ? path.slice(0, 2) : path };
}

/// On the terrain: at the first vertex of a section; elsewhere in the middle of what the engine says of its extent.
function placeOn(terrain: Row<'terrain'>, problems: readonly Problem[]): TomlValue[] {
  const { section } = terrain;
  if (Array.isArray(section) && terrain.width_m === undefined && Array.isArray(section[0])) return section[0];
  const extents = problems.map(({ why }) =>
    /x = (\S+) to (\S+), y = (\S+) to ([^\s)]+)/.exec(why)?.slice(1).map(Number),
  );
  const [west, east, south, north] = extents.find((extent) => extent?.every(Number.isFinite)) ?? [0, 0, 0, 0];
  return [(west! + east!) / 2, (south! + north!) / 2, 0];
}

const isOfTerrain = ({ path }: Problem) => path === 'terrain' || path.startsWith('terrain.');

/// What is wrong with a text, and what came to light of its terrain when something stood in for the rest. Lines of that
/// text are not those of the project.
export function withTerrainOf(found: readonly Problem[], withStandIns: readonly Problem[]): Problem[] {
  const isNew = ({ path, what }: Problem) => !found.some((known) => known.path === path && known.what === what);
  const terrain = withStandIns.filter((problem) => isOfTerrain(problem) && isNew(problem));
  const withoutLine = (problem: Problem) => ({
    ...problem,
    line: 0,
    text: problem.text.replace(`${problem.file}:${problem.line}:`, `${problem.file}:`),
  });
  return [...found, ...terrain.map(withoutLine)];
}

/// A text that may build, or null where the terrain itself is what is wrong.
export function withStandIns(text: string, problems: readonly Problem[]): string | null {
  try {
    const { terrain } = valuesOf(text);
    const errors = problems.filter(({ severity }) => severity === 'error');
    if (!isTable(terrain) || errors.some(isOfTerrain)) return null;
    const removes = errors.flatMap((problem) => removalFor(problem) ?? []);
    // From the last one on, so that numbers of entries hold.
    const inOrder = [...new Map(removes.map((edit) => [JSON.stringify(edit), edit])).values()].sort((a, b) =>
      JSON.stringify(b).localeCompare(JSON.stringify(a), 'en', { numeric: true }),
    );
    let next = edited(text, inOrder);
    const left = valuesOf(next);
    const isNone = (key: TableName) => !Array.isArray(left[key]) || left[key].length === 0;
    const seeder: Row<'seeder'> = { name, position: placeOn(terrain, errors), rocks: 1, mass_kg: 1000 };
    if (isNone('material')) next = edited(next, [{ append: ['material'], value: { name: 'Ground' } }]);
    if (isNone('seeder')) next = edited(next, [{ append: ['seeder'], value: seeder }]);
    return next === text ? null : next;
  } catch {
    return null;
  }
}

/// The model as it was built, without what only stood in.
export function withoutStandIns(model: Model): Model {
  const seeders = model.seeders.filter((seeder) => seeder.name !== name);
  return seeders.length === model.seeders.length ? model : { ...model, seeders, rocks: model.rocks - 1 };
}
