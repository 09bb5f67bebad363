// What stays in the asked stretch of the shown run.

import { batch, effect, signal } from '@preact/signals';
import { askDitch, type DitchAnswer } from '../api/ditch';
import { hasResults, shown } from '../runs/runs';
import { slopePane, stretch } from './state';

/// The last answer, also while the next one is loading.
export const stays = signal<DitchAnswer | null>(null);
export const refused = signal<string | null>(null);

effect(() => {
  const [run, [toe, far], pane] = [shown.value, stretch.value, slopePane.value];
  if (pane !== 'stays' || !run || !hasResults(run) || run.dimension !== 2) {
    [stays.value, refused.value] = [null, null];
    return;
  }
  const asking = new AbortController();
  const timer = setTimeout(async () => {
    try {
      const answer = await askDitch(run.id, toe, far, asking.signal);
      if (!asking.signal.aborted) batch(() => ([stays.value, refused.value] = [answer, null]));
    } catch (error) {
      if (!asking.signal.aborted) batch(() => ([stays.value, refused.value] = [null, error instanceof Error ? error.message : String(error)]));
    }
  }, 60);
  return () => {
    clearTimeout(timer);
    asking.abort();
  };
});
