// The selected rock of the shown run, by its number.

import { ofProject } from '../project/ofProject';
import { owned } from '../state/owned';
import { showTab } from '../state/panels';

export const [chosenRock, chooseRock] = owned(ofProject<number | null>(null));

/// Selects a rock and turns to its tab; null deselects.
export function showRock(next: number | null) {
  chooseRock(next);
  if (next !== null) showTab('rock');
}
