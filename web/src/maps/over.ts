// Trajectories and end points over a map. They would hide it, so they are drawn only on request.

import { computed } from '@preact/signals';
import { keptOfProject } from '../state/ofProject';
import { layers } from '../view/settings';
import { shownMap } from './shownMap';

export const pathsOverMap = keptOfProject<boolean>('paths over map', false);
const isFree = computed(() => shownMap.value === null || pathsOverMap.value);
export const arePathsShown = computed(() => layers.paths.value && isFree.value);
export const areEndsShown = computed(() => layers.ends.value && isFree.value);
