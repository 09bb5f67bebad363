// Trajectories and end points over a map. They would hide it, so each is drawn only on request.

import { computed } from '@preact/signals';
import { keptOfProject } from '../project/ofProject';
import { layers } from '../view/settings';
import { shownMap } from './shownMap';
import { owned } from '../state/owned';

export const [pathsOverMap, showPathsOverMap] = owned(keptOfProject<boolean>('paths over map', false));
export const [endsOverMap, showEndsOverMap] = owned(keptOfProject<boolean>('end points over map', false));
const isFree = computed(() => shownMap.value === null);
export const arePathsShown = computed(() => layers.paths.value && (isFree.value || pathsOverMap.value));
export const areEndsShown = computed(() => layers.ends.value && (isFree.value || endsOverMap.value));
