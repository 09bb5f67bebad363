// What if, of the shown run and what is asked of it: begun here, followed while it runs, and any change opened as a run.

import { computed, effect, signal } from '@preact/signals';
import { whatIfs, type Variation, type WhatIfFigure, type WhatIfState } from '../api/whatIf';
import { edited } from '../toml/edit';
import { textOf } from '../runs/runText';
import { kept } from '../state/kept';
import { attempt, reportFailure } from '../state/messages';
import { compute, shown } from '../state/runs';
import { sidePanel } from '../state/view';
import { asked } from './asked';
import { shapeOf } from './shape';
import { editsOf, nameOf } from './tornadoOf';

/// The last one that was begun on this page.
const last = signal<WhatIfState | null>(null);
export const whatIfFigure = kept<WhatIfFigure>('figure of what if', 'share');

const key = (run: string, shape: object) => `${run} ${JSON.stringify(shape)}`;
/// That of the shown run and of what is asked now; null: not begun.
export const whatIf = computed(() => {
  const [found, run, now] = [last.value, shown.value, asked.value];
  return found && run && now && key(found.run, found.question) === key(run.id, shapeOf(now)) ? found : null;
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

export const begin = () =>
  attempt('what if', async () => {
    if (shown.value && asked.value) last.value = await whatIfs.begin(shown.value.id, shapeOf(asked.value));
  });
export const stop = () =>
  attempt('what if', async () => {
    if (last.value) last.value = await whatIfs.stop(last.value.run);
  });

/// Computes the run's project with these values, with the same rocks. The open project stays as it is.
export const openAsRun = (of: WhatIfState, variation: Variation) =>
  attempt('what if', async () => {
    const text = edited(await textOf(of.run), editsOf(variation.changes));
    const { rocks, seed } = of.overrides;
    sidePanel.value = 'runs';
    await compute({ name: nameOf(variation), ...(rocks !== null && { rocks }), ...(seed !== null && { seed }) }, text);
  });
