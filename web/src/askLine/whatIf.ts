// What if, of the shown run and what is asked of it: begun here, followed while it runs, and any change opened as a run.

import { batch, computed, effect, signal, type ReadonlySignal } from '@preact/signals';
import { whatIfs, type Variation, type WhatIfFigure, type WhatIfOptions, type WhatIfState } from '../api/whatIf';
import { edited } from '../toml/edit';
import type { AskedShape } from '../api/line';
import { textOf } from '../runs/runText';
import { displayOf } from '../state/displayUnits';
import { kept } from '../state/kept';
import { attempt, reportFailure } from '../state/messages';
import { compute, hasResults, shown } from '../runs/runs';
import { showPanel } from '../state/panels';
import { asked } from './asked';
import { shapeOf } from './shape';
import { changeIn, editsOf, figures, nameOf } from './tornadoOf';
import { owned } from '../state/owned';

/// The last one that was begun, or found at the server.
const last = signal<WhatIfState | null>(null);
export const [whatIfFigure, chooseFigure] = owned(kept<WhatIfFigure>('figure of what if', 'share'));
export const unitOfChange = (by: WhatIfFigure) => changeIn(by, displayOf(figures[by].unit));

/// Names a question to a run.
export const questionKey = (run: string, { line, barrier, polygon }: AskedShape) => JSON.stringify([run, line, barrier, polygon]);
/// That of a question to the shown run; null: not begun, or another question was asked since.
export function whatIfOf(shape: AskedShape): WhatIfState | null {
  const [found, run] = [last.value, shown.value];
  return found && run && questionKey(found.run, found.question) === questionKey(run.id, shape) ? found : null;
}
/// That of what is asked now.
export const whatIf = computed(() => asked.value && whatIfOf(shapeOf(asked.value)));

const askedFor = signal<string | null>(null);
/// The run of which the last one is known, or known not to be.
export const knownOf: ReadonlySignal<string | null> = askedFor;

// One that was begun before the page was loaded, or in another tab, goes on at the server.
async function find(run: string) {
  try {
    const found = await whatIfs.state(run);
    if (shown.peek()?.id !== run) return;
    batch(() => {
      if (last.peek()?.run !== run) last.value = found;
      askedFor.value = run;
    });
  } catch (error) {
    reportFailure(error, 'what if');
  }
}
effect(() => {
  const run = shown.value;
  if (run && hasResults(run) && askedFor.peek() !== run.id) void find(run.id);
});

let timer: ReturnType<typeof setTimeout> | undefined;
async function follow(run: string) {
  try {
    const found = await whatIfs.state(run);
    if (last.value?.run !== run) return;
    last.value = found;
  } catch (error) {
    last.value = null;
    reportFailure(error, 'what if');
  }
}
const between = 400; // ms
effect(() => {
  clearTimeout(timer);
  const found = last.value;
  if (found?.state === 'running') timer = setTimeout(() => void follow(found.run), between);
});

const onItsWay = signal<string | null>(null);
const refused = signal<{ question: string; why: string } | null>(null);
const isOf = (question: string | undefined, shape: AskedShape) => shown.value !== null && question === questionKey(shown.value.id, shape);
/// Whether that of a question to the shown run is being sent to the server.
export const isBeginning = (shape: AskedShape) => isOf(onItsWay.value ?? undefined, shape);
/// Why that of a question to the shown run could not be begun, for example because of a step; null: it was, or not asked.
export const refusalOf = (shape: AskedShape) => (isOf(refused.value?.question, shape) ? refused.value!.why : null);

export async function begin(shape: AskedShape, options: WhatIfOptions) {
  const run = shown.peek()?.id;
  if (run === undefined) return;
  const question = questionKey(run, shape);
  batch(() => {
    refused.value = null;
    onItsWay.value = question;
  });
  try {
    const begun = await whatIfs.begin(run, { ...shape, ...options });
    batch(() => {
      last.value = begun;
      askedFor.value = run;
    });
  } catch (error) {
    refused.value = { question, why: error instanceof Error ? error.message : String(error) };
  } finally {
    if (onItsWay.peek() === question) onItsWay.value = null;
  }
}
export const stop = () =>
  attempt('what if', async () => {
    if (last.value) last.value = await whatIfs.stop(last.value.run);
  });

/// Computes the run's project with these values, with the same rocks. The open project stays as it is.
export const openAsRun = (of: WhatIfState, variation: Variation) =>
  attempt('what if', async () => {
    const text = edited(await textOf(of.run), editsOf(variation.changes));
    const { rocks, seed } = of.overrides;
    showPanel('runs');
    await compute({ name: nameOf(variation), ...(rocks !== null && { rocks }), ...(seed !== null && { seed }) }, text);
  });
