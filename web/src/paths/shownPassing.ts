// Which of the paths that are drawn the filter leaves.

import { computed, type ReadonlySignal } from '@preact/signals';
import { filter, isFiltering } from '../state/filter';
import { comparedPaths, shownPaths, type DrawnPaths } from './drawnPaths';
import { passing } from './passing';

/// Null: all pass.
const passingOf = (paths: ReadonlySignal<DrawnPaths | null>) =>
  computed<Uint8Array | null>(() =>
    paths.value && isFiltering(filter.value) ? passing(paths.value, filter.value) : null,
  );
export const shownPassing = passingOf(shownPaths);
export const comparedPassing = passingOf(comparedPaths);

/// Of the paths that are drawn, so many are left; null: nothing is filtered.
export const leftByFilter = computed<{ left: number; of: number } | null>(() => {
  const passes = shownPassing.value;
  return passes && { left: passes.reduce((sum, one) => sum + one, 0), of: passes.length };
});
