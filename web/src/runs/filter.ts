// The rock filter, shared by the views and the results.

import type { ReadonlySignal } from '@preact/signals';
import type { RockFilter } from '../api/results';
import { ofProject } from '../project/ofProject';
import { owned } from '../state/owned';

export const everyRock: RockFilter = {
  reasons: null,
  seeders: null,
  sources: null,
  barriers: null,
  releases: null,
  crossing: null,
  minEnergy_kJ: null,
  maxEnergy_kJ: null,
};

const conditions = ofProject<RockFilter>(everyRock);
export const filter: ReadonlySignal<RockFilter> = conditions;
/// Changes some conditions; the others stay.
export const filterBy = (change: Partial<RockFilter>) => void (conditions.value = { ...conditions.peek(), ...change });
export const showAllRocks = () => void (conditions.value = everyRock);

export const isFiltering = (now: RockFilter) => Object.values(now).some((condition) => condition !== null);

/// The rocks of `filter.crossing`; null while they are unknown.
export const [crossingRocks, setCrossingRocks] = owned(ofProject<ReadonlySet<number> | null>(null));
