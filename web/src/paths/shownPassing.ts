import { computed } from '@preact/signals';
import { filter, isFiltering } from '../state/filter';
import { shownPaths } from './drawnPaths';
import { passing } from './passing';

/// Of the paths that are shown; null: all pass.
export const shownPassing = computed<Uint8Array | null>(() =>
  shownPaths.value && isFiltering(filter.value) ? passing(shownPaths.value, filter.value) : null,
);
