// What lies over a map: paths and end points hide it, so that they are there only where they are asked for.

import { computed } from '@preact/signals';
import { keptOfProject } from '../state/ofProject';
import { layers } from '../view/settings';
import { shownMap } from './shownMap';

export const pathsOverMap = keptOfProject<boolean>('paths over map', false);
const isFree = computed(() => shownMap.value === null || pathsOverMap.value);
export const arePathsShown = computed(() => layers.paths.value && isFree.value);
export const areEndsShown = computed(() => layers.ends.value && isFree.value);
