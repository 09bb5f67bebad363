// The runs and calibrations of all projects, as reported by the server.

import { computed, effect, signal } from '@preact/signals';
import { api } from '../api/client';
import { leftOut } from '../project/leftOut';
import type { Run } from '../api/types';
import { file, text } from '../project/document';
import { checkFile } from '../project/fileOnDisk';
import { attempt, notify, reportFailure, resolve } from '../state/messages';
import { rebuild } from '../project/model';
import { ofProject } from '../project/ofProject';
import { subscribe } from '../state/news';
import { owned } from '../state/owned';

const all = signal<Run[]>([]);
export const runs = computed(() => all.value.filter(({ kind }) => kind === 'run'));
const calibrations = computed(() => all.value.filter(({ kind }) => kind === 'calibration'));
const chosenCalibration = signal<string | null>(null); // null: the newest with results
export const showCalibration = (id: string) => void (chosenCalibration.value = id);
const [shownRun, comparedRun] = [signal<string | null>(null), signal<string | null>(null)];
/// The shown run, and the one compared with it.
export const [shownId, show] = owned(shownRun);
export const [comparedId, compareWith] = owned(comparedRun);
/// Runs started on this page that were not played yet.
export const startedHere = new Set<string>();
export const isConnected = signal(true);
/// Whether the list of runs is loaded.
export const areKnown = signal(false);

const find = (id: string | null) => runs.value.find((run) => run.id === id) ?? null;
export const shown = computed(() => find(shownRun.value));
export const compared = computed(() => find(comparedRun.value));
export const running = computed(() => runs.value.find((run) => run.state === 'running') ?? null);
/// The runs of the open project, newest first.
export const ownRuns = computed(() => runs.value.filter((run) => run.file === file.value));

/// The calibrations of the open project, newest first.
export const ownCalibrations = computed(() => calibrations.value.filter((run) => run.file === file.value));
/// The calibration whose results are shown.
export const shownCalibration = computed(
  () =>
    ownCalibrations.value.find(({ id }) => id === chosenCalibration.value) ??
    ownCalibrations.value.find(({ has_results }) => has_results) ??
    null,
);

/// A failed run may have truncated tables, so its errors are shown instead.
export const hasResults = (run: Run) => run.has_results && run.state !== 'failed';

// Opening a project shows its newest results, or the run that an address asks for, and hides those of the previous project.
let pickedFor: string | null = null;
const asked = ofProject<{ run: string | null; compared: string | null } | null>(null);
effect(() => {
  const name = file.value;
  if (name === null || !areKnown.value) {
    if (name === null) [pickedFor, shownRun.value, comparedRun.value] = [null, null, null];
    return;
  }
  const wanted = asked.value;
  const own = (id: string | null) => ownRuns.peek().find((run) => run.id === id)?.id ?? null;
  if (pickedFor !== name) {
    pickedFor = name;
    shownRun.value = ownRuns.peek().find(hasResults)?.id ?? null;
    comparedRun.value = null;
  }
  if (wanted === null) return;
  asked.value = null;
  shownRun.value = own(wanted.run) ?? shownRun.peek();
  comparedRun.value = own(wanted.compared);
});
/// Shows runs of the open project, once the runs are known. Without a run, or if it was removed, the shown one stays.
export const showRuns = (run: string | null, compared: string | null) => (asked.value = { run, compared });

const isKnown = (id: string) => all.peek().some((run) => run.id === id);

/// Takes the run from a response, unless events already report its state, which may be newer.
export function takeAnswer(run: Run) {
  if (!isConnected.peek() || !isKnown(run.id)) take(run);
}

function take(run: Run) {
  const known = all.value.some(({ id }) => id === run.id);
  all.value = known ? all.value.map((old) => (old.id === run.id ? run : old)) : [run, ...all.value];
}

/// Runs the current project, or another text of it.
export async function compute(more: { name?: string; rocks?: number; seed?: number } = {}, other?: string) {
  await checkFile();
  if (file.value === null) return;
  try {
    const run = await api.compute(file.value, other ?? text.value, more);
    resolve('compute');
    startedHere.add(run.id);
    takeAnswer(run);
    shownRun.value = run.id;
    void rebuild();
    if (leftOut()) notify('note', `Computed${leftOut()}`);
  } catch (error) {
    reportFailure(error, 'compute');
  }
}
// An error of a run refers to one version of the text.
effect(() => {
  void text.value;
  resolve('compute');
});

export const stop = (id: string) => attempt(`run ${id}`, () => api.stopRun(id).then(takeAnswer));
export const writePartialResults = (id: string) => attempt(`run ${id}`, () => api.writeRun(id).then(takeAnswer));
export const resume = (id: string) => attempt(`run ${id}`, () => api.resumeRun(id).then(takeAnswer));
export const rename = (id: string, name: string) => attempt(`run ${id}`, () => api.renameRun(id, name).then(takeAnswer));
export const remove = (id: string) => attempt(`run ${id}`, () => api.removeRun(id).then(() => forget(id)));

function forget(id: string) {
  all.value = all.value.filter((run) => run.id !== id);
  if (shownRun.value === id) shownRun.value = null;
  if (comparedRun.value === id) comparedRun.value = null;
}

/// Loads the current list of runs.
const loadRuns = () =>
  attempt('runs', async () => {
    all.value = await api.runs();
    areKnown.value = true;
  });

/// Follows the events of the server and reconnects if the connection is lost. Returns a function that ends this.
export function follow(): () => void {
  void loadRuns();
  return subscribe(['run', 'removed'], (news) => {
    if (news.kind !== 'event') {
      isConnected.value = news.kind === 'connected';
      if (isConnected.value) void loadRuns();
    } else if (news.event === 'run') take(JSON.parse(news.data) as Run);
    else forget((JSON.parse(news.data) as { id: string }).id);
  });
}
