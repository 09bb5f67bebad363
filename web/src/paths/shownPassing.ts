// The filter applied to the drawn trajectories.

import { computed, type ReadonlySignal } from '@preact/signals';
import { filter, isFiltering } from '../state/filter';
import { comparedPaths, shownPaths, type DrawnPaths } from './drawnPaths';
import { passing } from './passing';

/// Null if all pass.
const passingOf = (paths: ReadonlySignal<DrawnPaths | null>) =>
  computed<Uint8Array | null>(() =>
    paths.value && isFiltering(filter.value) ? passing(paths.value, filter.value) : null,
  );
export const shownPassing = passingOf(shownPaths);
export const comparedPassing = passingOf(comparedPaths);

/// The number of drawn trajectories that pass the filter; null if there is no filter.
export const leftByFilter = computed<{ left: number; of: number } | null>(() => {
  const passes = shownPassing.value;
  return passes && { left: passes.reduce((sum, one) => sum + one, 0), of: passes.length };
});
