// The runs beside the open projects, as the server tells of them.

import { computed, effect, signal } from '@preact/signals';
import { api } from '../api/client';
import { leftOut } from '../model/leftOut';
import type { Run } from '../api/types';
import { file, text } from './document';
import { lookAtFile } from './fileOnDisk';
import { attempt, say, sayFailure, settle } from './messages';
import { lookAgain } from './model';
import { hearNews } from './news';

export const runs = signal<Run[]>([]);
/// The run that is looked at, and one that is laid over it.
export const shownId = signal<string | null>(null);
export const comparedId = signal<string | null>(null);
/// Runs that this page began and whose rocks were not seen yet.
export const startedHere = new Set<string>();
export const isConnected = signal(true);
/// Whether the server has told of its runs.
export const areKnown = signal(false);

const find = (id: string | null) => runs.value.find((run) => run.id === id) ?? null;
export const shown = computed(() => find(shownId.value));
export const compared = computed(() => find(comparedId.value));
export const running = computed(() => runs.value.find((run) => run.state === 'running') ?? null);
/// Of the open project, newest first.
export const ownRuns = computed(() => runs.value.filter((run) => run.file === file.value));

/// One that failed may have tables that end anywhere: what is wrong with it is shown instead.
export const hasResults = (run: Run) => run.has_results && run.state !== 'failed';

// Who opens a project sees its newest results; what is shown of another project goes.
let pickedFor: string | null = null;
effect(() => {
  const name = file.value;
  if (name === null || !areKnown.value || pickedFor === name) {
    if (name === null) pickedFor = null;
    return;
  }
  pickedFor = name;
  shownId.value = ownRuns.peek().find(hasResults)?.id ?? null;
  comparedId.value = null;
});

const isKnown = (id: string) => runs.peek().some((run) => run.id === id);

/// What a request answered. Events tell of the same change, and may have told of later ones already.
function takeAnswer(run: Run) {
  if (!isConnected.peek() || !isKnown(run.id)) take(run);
}

function take(run: Run) {
  const known = runs.value.some(({ id }) => id === run.id);
  runs.value = known ? runs.value.map((old) => (old.id === run.id ? run : old)) : [run, ...runs.value];
}

/// Throws the rocks of the text as it stands.
export async function compute(more: { name?: string; rocks?: number; seed?: number } = {}) {
  await lookAtFile();
  if (file.value === null) return;
  try {
    const run = await api.compute(file.value, text.value, more);
    settle('compute');
    startedHere.add(run.id);
    takeAnswer(run);
    shownId.value = run.id;
    void lookAgain();
    if (leftOut()) say('note', `Computed${leftOut()}`);
  } catch (error) {
    sayFailure(error, 'compute');
  }
}
// What is said against a text holds for no other.
effect(() => {
  void text.value;
  settle('compute');
});

export const stop = (id: string) => attempt(`run ${id}`, () => api.stopRun(id).then(takeAnswer));
export const writeWhatIsDone = (id: string) => attempt(`run ${id}`, () => api.writeRun(id).then(takeAnswer));
export const resume = (id: string) => attempt(`run ${id}`, () => api.resumeRun(id).then(takeAnswer));
export const rename = (id: string, name: string) => attempt(`run ${id}`, () => api.renameRun(id, name).then(takeAnswer));
export const remove = (id: string) => attempt(`run ${id}`, () => api.removeRun(id).then(() => forget(id)));

function forget(id: string) {
  runs.value = runs.value.filter((run) => run.id !== id);
  if (shownId.value === id) shownId.value = null;
  if (comparedId.value === id) comparedId.value = null;
}

/// The runs as they are now, whatever was heard of them before.
const catchUp = () =>
  attempt('runs', async () => {
    runs.value = await api.runs();
    areKnown.value = true;
  });

/// Follows what the server tells; when it is gone, goes on trying.
export function follow(): () => void {
  void catchUp();
  return hearNews(['run', 'removed'], (news) => {
    if (news.kind !== 'event') {
      isConnected.value = news.kind === 'connected';
      if (isConnected.value) void catchUp();
    } else if (news.event === 'run') take(JSON.parse(news.data) as Run);
    else forget((JSON.parse(news.data) as { id: string }).id);
  });
}
