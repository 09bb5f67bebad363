// The model that the engine builds from the open project, and its problems.

import { batch, effect, signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Model, Problem } from '../api/types';
import { withoutPlaceholders, withPlaceholders, withTerrainProblems } from './placeholders';
import { file, text } from './document';
import { reportFailure, resolve } from '../state/messages';
import { owned } from '../state/owned';

/// The last model that could be built. While a change is being checked, or if its terrain has errors, it is that of an
/// earlier text. Other entries with errors are left out.
export const model = signal<Model | null>(null);
export const problems = signal<Problem[]>([]);
/// Of the files of reference layers: warnings, because a run does without them.
export const [layerProblems, setLayerProblems] = owned(signal<Problem[]>([]));
export const isBuilding = signal(false);
/// Whether the terrain has errors and `model` is that of an earlier text.
export const isStale = signal(false);
/// Whether the model of the present text and files is still to come.
const isAwaited = signal(false);

/// The model of the present text, once it is built; null: it cannot be built, or the project was closed.
export const modelNow = (): Promise<Model | null> =>
  new Promise((resolve) => {
    const end: () => void = effect(() => {
      if (isAwaited.value) return;
      resolve(isStale.peek() ? null : model.peek());
      queueMicrotask(() => end());
    });
  });

let asking: AbortController | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;
let modelFile: string | null = null;
let lastTook = 0; // ms
let mayBeOld = false; // files may have changed since the model under way was asked for

/// Builds the model from the current text and its files.
export const build = () => ask(() => true);
/// Builds it again because a file may have changed; an equal model is kept.
export const rebuild = () => ask(({ id }) => id !== model.value?.id);

async function ask(isWanted: (next: Model) => boolean) {
  clearTimeout(timer);
  asking?.abort();
  if (file.value === null) return;
  const own = new AbortController();
  asking = own;
  isBuilding.value = true;
  isAwaited.value = true;
  mayBeOld = false;
  const begun = performance.now();
  const [name, now] = [file.value, text.value];
  try {
    const { model: shown, found } = await modelOf(name, now, own.signal);
    if (own.signal.aborted) return;
    resolve('model');
    lastTook = performance.now() - begun;
    batch(() => {
      problems.value = found;
      isStale.value = shown === null && modelFile === name && model.value !== null;
      if (modelFile !== name || (shown && isWanted(shown))) model.value = shown;
      modelFile = name;
    });
  } catch (error) {
    if (own.signal.aborted) return;
    if (error instanceof Refused) problems.value = error.problems;
    else reportFailure(error, 'model');
  } finally {
    if (asking === own) {
      isBuilding.value = false;
      if (file.value === name && text.value === now) isAwaited.value = false; // else a later text is
      if (mayBeOld) lookAgain();
    }
  }
}

/// The model of a text and its problems; entries with errors are left out, and missing ones are replaced.
export async function modelOf(name: string, now: string, signal?: AbortSignal) {
  const answer = await api.model(name, now, signal);
  if (answer.model) return { model: answer.model, found: answer.problems };
  return buildWithPlaceholders(name, now, answer.problems, signal);
}

/// The model of a text that cannot run yet, with placeholders for missing entries, and the problems of the text.
async function buildWithPlaceholders(name: string, now: string, ofText: Problem[], signal?: AbortSignal) {
  let [next, current]: [string | null, Problem[]] = [now, ofText];
  // Problems of seeders on the terrain are only found once the terrain can be built.
  for (let round = 0; round < 3; ++round) {
    next = withPlaceholders(next, current);
    if (next === null) break;
    const answer = await api.model(name, next, signal);
    current = answer.problems;
    if (answer.model)
      return { model: withoutPlaceholders(answer.model), found: withTerrainProblems(ofText, current) };
  }
  return { model: null, found: withTerrainProblems(ofText, current) };
}

effect(() => {
  const name = file.value;
  void text.value;
  clearTimeout(timer);
  isAwaited.value = name !== null;
  if (name === null) {
    asking?.abort();
    modelFile = null;
    model.value = null;
    isStale.value = false;
    problems.value = [];
    return;
  }
  timer = setTimeout(() => void build(), modelFile === name ? 300 : 0);
});

/// Files can change while the page is in the background. Only models that build quickly are rebuilt on focus.
const quick = 2000; // ms
const lookAgain = () => {
  if (lastTook < quick) void rebuild();
};
addEventListener('focus', () => {
  if (isBuilding.value) mayBeOld = true;
  else lookAgain();
});

/// The problems at a path or below it: "material.0.normal_restitution".
export function problemsAt(path: string): Problem[] {
  return [...problems.value, ...layerProblems.value].filter((problem) => problem.path === path || problem.path.startsWith(`${path}.`));
}
