// The selected entry of the project: its form is open, and the views highlight it.

import type { Path } from '../settings/names';
import { owned } from '../state/owned';
import { showPanel, sidePanel, unfoldForms } from '../state/panels';
import { ofProject } from './ofProject';

/// Its path, such as ["seeder", 0], and what selects it without unfolding the forms, as addresses do.
export const [chosen, turnTo] = owned(ofProject<Path | null>(null));

export function choose(next: Path | null) {
  turnTo(next);
  if (next !== null && sidePanel.peek() === 'model') unfoldForms();
}

/// Opens its form in the panel at the left.
export function openForm(next: Path | null) {
  choose(next);
  showPanel('model');
}
