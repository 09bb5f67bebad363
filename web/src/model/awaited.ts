// The engine's problems as the page tells them: what is still to come is no reproach.

import { computed } from '@preact/signals';
import type { Problem } from '../api/types';
import { values } from '../state/document';
import { problems } from '../state/model';
import { nextSteps } from './things';

/// Whether a problem says no more than that something is still to come.
const isAwaited = (problem: Problem, keys: string[]) =>
  keys.some(
    (key) =>
      problem.path === key ||
      problem.path.startsWith(`${key}.`) ||
      problem.what.startsWith(`[[${key}]] is missing`) ||
      problem.what.startsWith(`[${key}] is missing`),
  );

/// What the engine says, but for what the next steps say already.
export const realProblems = computed<Problem[]>(() => {
  const keys = nextSteps(values.value).map(({ key }) => key as string);
  return problems.value.filter((problem) => !isAwaited(problem, keys));
});

/// Those of a path, or below it.
export const realProblemsAt = (path: string) =>
  realProblems.value.filter((problem) => problem.path === path || problem.path.startsWith(`${path}.`));

/// A sentence without the place, which its field shows.
export const sentenceOf = ({ what, why, hint }: Problem) =>
  `${what}${why ? ` (${why})` : ''}${hint ? `. ${hint}` : ''}`;

/// How loudly it is said: what is only missing is still to come.
export const toneOf = ({ what, severity }: Problem) => (/ (is|are) missing$/.test(what) ? 'warning' : severity);
