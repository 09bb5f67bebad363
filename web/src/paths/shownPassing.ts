// The filter applied to the drawn trajectories.

import { computed, signal, type ReadonlySignal } from '@preact/signals';
import { crossingRocks, filter, isFiltering } from '../runs/filter';
import { comparedPaths, shownPaths, type DrawnPaths } from './drawnPaths';
import { passing } from './passing';

/// Null if all pass.
const passingOf = (paths: ReadonlySignal<DrawnPaths | null>, crossing: ReadonlySignal<ReadonlySet<number> | null>) =>
  computed<Uint8Array | null>(() =>
    paths.value && isFiltering(filter.value) ? passing(paths.value, filter.value, crossing.value) : null,
  );
export const shownPassing = passingOf(shownPaths, crossingRocks);
/// The numbers of the rocks that cross a line are those of the shown run.
export const comparedPassing = passingOf(comparedPaths, signal(null));

/// The number of drawn trajectories that pass the filter; null if there is no filter.
export const leftByFilter = computed<{ left: number; of: number } | null>(() => {
  const passes = shownPassing.value;
  return passes && { left: passes.reduce((sum, one) => sum + one, 0), of: passes.length };
});
