// Which rocks of the shown run are looked at: one filter for the paths in the view and for the figures below it.

import { computed, signal } from '@preact/signals';
import type { Arrays } from '../api/arrays';

/// What passes by names; an empty list lets all pass. Several of a kind are joined by "or", kinds by "and".
export interface RockFilter {
  reasons: string[];
  seeders: string[];
  sources: string[];
  /// Rocks that hit one of these.
  barriers: string[];
  /// Bounds of the greatest kinetic energy of a rock, kJ.
  minEnergy: number | null;
  maxEnergy: number | null;
}

export const noFilter: RockFilter = {
  reasons: [],
  seeders: [],
  sources: [],
  barriers: [],
  minEnergy: null,
  maxEnergy: null,
};

export const filter = signal<RockFilter>(noFilter);
export const isFiltering = computed(() => filterQuery(filter.value) !== '');

/// The filter as the server takes it, for statistics: "reason=at%20rest&min_energy_kJ=10".
export function filterQuery(of: RockFilter): string {
  const query = new URLSearchParams();
  const lists = { reason: of.reasons, seeder: of.seeders, source: of.sources, barrier: of.barriers };
  for (const [key, names] of Object.entries(lists)) for (const name of names) query.append(key, name);
  if (of.minEnergy !== null) query.set('min_energy_kJ', String(of.minEnergy));
  if (of.maxEnergy !== null) query.set('max_energy_kJ', String(of.maxEnergy));
  return query.toString();
}

/// What the headers of paths and end points name.
export interface RockNames {
  sources: string[];
  seeders: string[];
  reasons: string[];
  barriers: string[];
  total: number;
}

/// For each rock of an answer with a row a rock, whether the filter lets it pass.
export function passing({ header, arrays }: Arrays<RockNames>, of: RockFilter): (rock: number) => boolean {
  const member = (names: string[], wanted: string[], of: ArrayLike<number> | undefined) => {
    if (wanted.length === 0 || !of) return () => true;
    const wantedIndex = names.map((name) => wanted.includes(name));
    return (rock: number) => wantedIndex[of[rock]!] ?? false;
  };
  const reason = member(header.reasons, of.reasons, arrays.reasons);
  const seeder = member(header.seeders, of.seeders, arrays.seeders);
  const source = member(header.sources, of.sources, arrays.sources);
  const { barriers, max_energies: energies } = arrays;
  const mask = of.barriers.reduce((bits, name) => bits | (1 << header.barriers.indexOf(name)), 0);
  const [least, most] = [of.minEnergy ?? -Infinity, of.maxEnergy ?? Infinity];
  return (rock) =>
    reason(rock) &&
    seeder(rock) &&
    source(rock) &&
    (of.barriers.length === 0 || !barriers || (barriers[rock]! & mask) !== 0) &&
    (!energies || (energies[rock]! >= least && energies[rock]! <= most));
}
