// What if, of the shown run and what is asked of it: begun here, followed while it runs, and any change opened as a run.

import { computed, effect, signal } from '@preact/signals';
import { whatIfs, type Variation, type WhatIfFigure, type WhatIfOptions, type WhatIfState } from '../api/whatIf';
import { edited } from '../toml/edit';
import type { AskedShape } from '../api/line';
import { textOf } from '../runs/runText';
import { displayOf } from '../state/displayUnits';
import { kept } from '../state/kept';
import { attempt, reportFailure } from '../state/messages';
import { compute, hasResults, shown } from '../runs/runs';
import { showPanel } from '../state/panels';
import { asked, isAsking } from './asked';
import { shapeOf } from './shape';
import { changeIn, editsOf, figures, nameOf } from './tornadoOf';
import { owned } from '../state/owned';

/// The last one that was begun, or found at the server.
const last = signal<WhatIfState | null>(null);
export const [whatIfFigure, chooseFigure] = owned(kept<WhatIfFigure>('figure of what if', 'share'));
export const unitOfChange = (by: WhatIfFigure) => changeIn(by, displayOf(figures[by].unit));

const key = (run: string, { line, barrier, polygon }: AskedShape) => JSON.stringify([run, line, barrier, polygon]);
/// That of the shown run and of what is asked now; null: not begun.
export const whatIf = computed(() => {
  const [found, run, now] = [last.value, shown.value, asked.value];
  return found && run && now && key(found.run, found.question) === key(run.id, shapeOf(now)) ? found : null;
});

// One that was begun before the page was loaded, or in another tab, goes on at the server.
async function find(run: string) {
  try {
    const found = await whatIfs.state(run);
    if (shown.peek()?.id === run && last.peek()?.run !== run) last.value = found;
  } catch (error) {
    reportFailure(error, 'what if');
  }
}
effect(() => {
  const run = shown.value;
  if (isAsking.value && run && hasResults(run) && last.peek()?.run !== run.id) void find(run.id);
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

/// Why the last one could not be begun, for example because of a step; null: it was.
export const refusal = signal<string | null>(null);

export async function begin(options: WhatIfOptions) {
  if (!shown.value || !asked.value) return;
  refusal.value = null;
  try {
    last.value = await whatIfs.begin(shown.value.id, { ...shapeOf(asked.value), ...options });
  } catch (error) {
    refusal.value = error instanceof Error ? error.message : String(error);
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
