// The selected rock of the shown run, by its number.

import { ofProject } from '../project/ofProject';
import { owned } from '../state/owned';
import { openResults, showTab } from '../state/panels';

export const [chosenRock, chooseRock] = owned(ofProject<number | null>(null));

/// Selects a rock and shows its table; null deselects.
export function showRock(next: number | null) {
  chooseRock(next);
  if (next === null) return;
  showTab('rock');
  openResults();
}
