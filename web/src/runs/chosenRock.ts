// The selected rock of the shown run, by its number.

import type { ReadonlySignal } from '@preact/signals';
import { ofProject } from '../project/ofProject';
import { showTab } from '../state/panels';

const number = ofProject<number | null>(null);
export const chosenRock: ReadonlySignal<number | null> = number;
export const chooseRock = (next: number | null) => void (number.value = next);

/// Selects a rock and turns to its tab; null deselects.
export function showRock(next: number | null) {
  chooseRock(next);
  if (next !== null) showTab('rock');
}
