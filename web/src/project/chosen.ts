// The selected entry of the project: its form is open, and the views highlight it.

import type { ReadonlySignal } from '@preact/signals';
import type { Path } from '../settings/names';
import { showPanel } from '../state/panels';
import { ofProject } from './ofProject';

const path = ofProject<Path | null>(null);
/// Its path, such as ["seeder", 0].
export const chosen: ReadonlySignal<Path | null> = path;
export const choose = (next: Path | null) => void (path.value = next);

/// Opens its form in the panel at the left.
export function openForm(next: Path | null) {
  choose(next);
  showPanel('model');
}
