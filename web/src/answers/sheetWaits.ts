// The sheet of the answers, asked for before the ranges over inputs and rock models are known: it waits for them.

import { effect, signal, untracked } from '@preact/signals';
import { shapeOf } from '../askLine/shape';
import { questionKey } from '../askLine/whatIf';
import { shown } from '../runs/runs';
import { owned } from '../state/owned';
import { ranges } from './job';
import { place } from './place';
import { printAnswer } from './printAnswer';
import { arePending } from './ranges';

/// What the sheet is for; null: none waits.
const [waitsFor, waitFor] = owned(signal<string | null>(null));
export { waitsFor };

const asked = () => (shown.value && place.value ? questionKey(shown.value.id, shapeOf(place.value)) : null);
const isReady = () => !ranges.value || !arePending(ranges.value);

/// Prints the sheet as soon as nothing is missing.
export const wantSheet = () => untracked(() => (isReady() ? void printAnswer() : waitFor(asked())));
export const printNow = () => {
  waitFor(null);
  void printAnswer();
};
export const leaveSheet = () => waitFor(null);

effect(() => {
  if (waitsFor.value === null) return;
  if (waitsFor.value !== asked()) return leaveSheet(); // another run or place is looked at
  if (isReady()) untracked(printNow);
});
