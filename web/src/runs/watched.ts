// Runs whose end the page has seen coming: those that were shown while they were under way.

import { effect, signal } from '@preact/signals';
import { hasResults, shown, startedHere } from './runs';

const underWay = new Set<string>();
const lastEnded = signal<string | null>(null);
/// The shown run, once it has ended with results while it was watched; null: none has.
export const endedHere = lastEnded;

effect(() => {
  const run = shown.value;
  if (!run) return;
  if (run.state === 'waiting' || run.state === 'running') return void underWay.add(run.id);
  // A quick run may have ended before it was first reported.
  if (!underWay.delete(run.id) && !startedHere.has(run.id)) return;
  if (hasResults(run)) lastEnded.value = run.id;
});
