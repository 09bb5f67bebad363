// The engine's problems as the page shows them. Whatever a next step already asks for is not shown as an error.

import { computed } from '@preact/signals';
import type { Problem } from '../api/types';
import { values } from './document';
import { layerProblems, problems, problemsAt } from './model';
import { pathOf, type Path } from '../settings/names';
import { columnsAt } from './columns';
import { pathText } from './place';
import { sentence } from './problemText';
import { fieldOf } from '../settings/declared';
import { nextSteps } from './things';
import { waitingAt } from './unfinished';
import { placeInTable } from '../settings/waitingRows';

/// Whether a problem only says that something is missing which a next step asks for.
const isAwaited = (problem: Problem, keys: string[]) =>
  keys.some(
    (key) =>
      problem.path === key ||
      problem.path.startsWith(`${key}.`) ||
      problem.what.startsWith(`[[${key}]] is missing`) ||
      problem.what.startsWith(`[${key}] is missing`),
  );

/// The engine's problems, except those covered by next steps.
export const realProblems = computed<Problem[]>(() => {
  const keys = nextSteps(values.value).map(({ key }) => key as string);
  return [...problems.value.filter((problem) => !isAwaited(problem, keys)), ...layerProblems.value];
});

/// The problems at a path or below it.
export const realProblemsAt = (path: string) =>
  realProblems.value.filter((problem) => problem.path === path || problem.path.startsWith(`${path}.`));

/// The path of the setting of a problem: in a table, or in an entry of a list.
function settingOf(path: string): Path {
  const parts = pathOf(path);
  return parts.slice(0, typeof parts[1] === 'number' ? 3 : 2);
}

/// The sentence of a problem without its location, which the field shows.
export function sentenceOf(problem: Problem): string {
  const setting = settingOf(problem.path);
  const kind = fieldOf(String(setting[0]), String(setting.at(-1)))?.type.kind;
  const rows = kind === 'lists of rows' ? pathOf(problem.path).slice(0, 3) : setting;
  const waiting = waitingAt(pathText(rows));
  return sentence(problem, { kind, columns: columnsAt(setting), rowAt: (row) => placeInTable(waiting, row) });
}

/// A missing value is shown as a warning, everything else by its severity.
export const toneOf = ({ what, severity }: Problem) => (/ (is|are) missing$/.test(what) ? 'warning' : severity);

/// The problems of a setting: at its path, or at its table if they begin with its key, such as a missing key.
export function problemsOf(path: Path): Problem[] {
  const [own, table, key] = [pathText(path), pathText(path.slice(0, -1)), String(path.at(-1))];
  const ofTable = problems.value.filter((problem) => problem.path === table && problem.what.startsWith(`${key} `));
  return [...problemsAt(own), ...ofTable];
}

/// The problems of a table as a whole, not of one of these settings.
export const problemsOfTable = (path: Path, keys: readonly string[]) =>
  realProblems.value.filter(
    (problem) => problem.path === pathText(path) && !keys.some((key) => problem.what.startsWith(`${key} `)),
  );
