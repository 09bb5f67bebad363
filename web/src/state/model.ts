// The model that the engine builds of the open project, and what it says against it.

import { batch, effect, signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Model, Problem } from '../api/types';
import { file, text } from './document';
import { sayFailure } from './messages';

/// The last one that could be built; while a change is looked at, or has errors, it is that of the text before.
export const model = signal<Model | null>(null);
export const problems = signal<Problem[]>([]);
export const isBuilding = signal(false);
/// Whether `model` is of the text as it stands.
export const isCurrent = signal(false);

let asking: AbortController | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;
let modelFile: string | null = null;

export async function build() {
  clearTimeout(timer);
  asking?.abort();
  if (file.value === null) return;
  const own = new AbortController();
  asking = own;
  isBuilding.value = true;
  const name = file.value;
  try {
    const answer = await api.model(name, text.value, own.signal);
    if (own.signal.aborted) return;
    batch(() => {
      problems.value = answer.problems;
      if (answer.model || modelFile !== name) model.value = answer.model;
      modelFile = name;
      isCurrent.value = answer.model !== null;
    });
  } catch (error) {
    if (own.signal.aborted) return;
    if (error instanceof Refused) problems.value = error.problems;
    else sayFailure(error);
  } finally {
    if (asking === own) isBuilding.value = false;
  }
}

effect(() => {
  const name = file.value;
  void text.value;
  isCurrent.value = false;
  clearTimeout(timer);
  if (name === null) {
    asking?.abort();
    modelFile = null;
    model.value = null;
    problems.value = [];
    return;
  }
  timer = setTimeout(() => void build(), modelFile === name ? 300 : 0);
});

/// What is wrong with the value at a path, or in it: "material.0.normal_restitution".
export function problemsAt(path: string): Problem[] {
  return problems.value.filter((problem) => problem.path === path || problem.path.startsWith(`${path}.`));
}
