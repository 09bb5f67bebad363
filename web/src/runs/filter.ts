// The rock filter, shared by the views and the results.

import { ofProject } from '../project/ofProject';

/// All conditions must be met; the names of a list are alternatives; null: no condition.
export interface RockFilter {
  reasons: string[] | null;
  seeders: string[] | null;
  sources: string[] | null;
  barriers: string[] | null;
  /// Numbers of release places of the shown run.
  releases: number[] | null;
  /// The rocks that cross an asked line: the server's name of their selection.
  crossing: string | null;
  minEnergy_kJ: number | null;
  maxEnergy_kJ: number | null;
}

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
