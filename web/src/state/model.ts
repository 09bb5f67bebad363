// The model that the engine builds of the open project, and what it says against it.

import { batch, effect, signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Model, Problem } from '../api/types';
import { withoutStandIns, withStandIns, withTerrainOf } from '../model/standIn';
import { file, text } from './document';
import { sayFailure, settle } from './messages';

/// The last one that could be built; while a change is looked at, or its terrain has errors, it is that of the text
/// before. What has errors elsewhere is left out of it.
export const model = signal<Model | null>(null);
export const problems = signal<Problem[]>([]);
export const isBuilding = signal(false);
/// Whether the terrain of the text has errors, and `model` is that of the text before.
export const isOfBefore = signal(false);

let asking: AbortController | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;
let modelFile: string | null = null;
let lastTook = 0; // ms

/// Of the text as it stands, and of the files that it names.
export const build = () => ask(() => true);
/// The same where a file may have changed; a model that is as it was stays.
export const lookAgain = () => ask(({ id }) => id !== model.value?.id);

async function ask(isWanted: (next: Model) => boolean) {
  clearTimeout(timer);
  asking?.abort();
  if (file.value === null) return;
  const own = new AbortController();
  asking = own;
  isBuilding.value = true;
  const begun = performance.now();
  const name = file.value;
  try {
    const answer = await api.model(name, text.value, own.signal);
    const { model: shown, wrong } = answer.model
      ? { model: answer.model, wrong: answer.problems }
      : await buildWithStandIns(name, text.value, answer.problems, own.signal);
    if (own.signal.aborted) return;
    settle('model');
    lastTook = performance.now() - begun;
    batch(() => {
      problems.value = wrong;
      isOfBefore.value = shown === null && modelFile === name && model.value !== null;
      if (modelFile !== name || (shown && isWanted(shown))) model.value = shown;
      modelFile = name;
    });
  } catch (error) {
    if (own.signal.aborted) return;
    if (error instanceof Refused) problems.value = error.problems;
    else sayFailure(error, 'model');
  } finally {
    if (asking === own) isBuilding.value = false;
  }
}

/// The model of a text that cannot run yet, as far as it goes, and what is wrong with the text.
async function buildWithStandIns(name: string, now: string, found: Problem[], signal: AbortSignal) {
  let [next, wrong]: [string | null, Problem[]] = [now, found];
  // What is wrong on the terrain is seen only when the rest is right.
  for (let round = 0; round < 3; ++round) {
    next = withStandIns(next, wrong);
    if (next === null) break;
    const answer = await api.model(name, next, signal);
    wrong = answer.problems;
    if (answer.model) return { model: withoutStandIns(answer.model), wrong: withTerrainOf(found, wrong) };
  }
  return { model: null, wrong: withTerrainOf(found, wrong) };
}

effect(() => {
  const name = file.value;
  void text.value;
  clearTimeout(timer);
  if (name === null) {
    asking?.abort();
    modelFile = null;
    model.value = null;
    isOfBefore.value = false;
    problems.value = [];
    return;
  }
  timer = setTimeout(() => void build(), modelFile === name ? 300 : 0);
});

/// Files can change while nobody looks at the page. Built again is only what is built in no time.
const quick = 2000; // ms
addEventListener('focus', () => {
  if (!isBuilding.value && lastTook < quick) void lookAgain();
});

/// What is wrong with the value at a path, or in it: "material.0.normal_restitution".
export function problemsAt(path: string): Problem[] {
  return problems.value.filter((problem) => problem.path === path || problem.path.startsWith(`${path}.`));
}
