// The selected entry of the project: its form is open, and the views highlight it.

import type { Path } from '../settings/names';
import { owned } from '../state/owned';
import { showPanel } from '../state/panels';
import { ofProject } from './ofProject';

/// Its path, such as ["seeder", 0].
export const [chosen, choose] = owned(ofProject<Path | null>(null));

/// Opens its form in the panel at the left.
export function openForm(next: Path | null) {
  choose(next);
  showPanel('model');
}
