// The rock filter, shared by the views and the results.

import type { RockFilter } from '../api/results';
import { ofProject } from '../project/ofProject';

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

export const filter = ofProject<RockFilter>(everyRock);

export const isFiltering = (now: RockFilter) => Object.values(now).some((condition) => condition !== null);

/// The rocks of `filter.crossing`; null while they are unknown.
export const crossingRocks = ofProject<ReadonlySet<number> | null>(null);
