// The line that the page answers for: the one that is asked, or else the road or another barrier of the run.

import { computed } from '@preact/signals';
import { results, type Summary } from '../api/results';
import { asked } from '../askLine/asked';
import { hasResults, shown } from '../runs/runs';
import { loadedFor } from '../state/loaded';
import { placeOf, type RunBarrier } from './whichPlace';

const loaded = loadedFor<Summary>(() => {
  const run = shown.value;
  return run && hasResults(run) ? { key: `${run.id} ${run.done}`, load: (signal) => results.summary(run.id, signal) } : null;
});
/// Of the shown run; null: unknown.
export const summary = computed(() => loaded.value.value);

export const runBarriers = computed<readonly RunBarrier[]>(() => summary.value?.barriers ?? []);

export const place = computed(() => {
  const run = shown.value;
  return run && hasResults(run) ? placeOf(asked.value, run.dimension, runBarriers.value) : null;
});
