// Applies a filter to the rocks.

import type { RockFilter } from '../api/results';
import type { DrawnPaths } from './drawnPaths';

type Rocks = Pick<DrawnPaths, 'rocks' | 'reasons' | 'seeders' | 'sources' | 'releases' | 'barriers' | 'maxEnergies'> & {
  header: Pick<DrawnPaths['header'], 'reasons' | 'seeders' | 'sources' | 'barriers'>;
};

/// A bit set of the chosen names.
function bitsOf(names: readonly string[], chosen: readonly string[]): Uint32Array {
  const wanted = new Set(chosen);
  const words = new Uint32Array(Math.max(1, Math.ceil(names.length / 32)));
  names.forEach((name, k) => {
    if (wanted.has(name)) words[k >> 5]! |= 1 << (k & 31);
  });
  return words;
}

/// For each rock 1 if it passes the filter, otherwise 0. `crossing`: the rocks of the filter's selection, null: unknown,
/// then all pass this condition.
export function passing(rocks: Rocks, now: RockFilter, crossing: ReadonlySet<number> | null = null): Uint8Array {
  const { header, reasons, seeders, sources, releases, barriers, maxEnergies } = rocks;
  const starts = now.releases && new Set(now.releases);
  const allowed = (names: string[], chosen: string[] | null) => names.map((name) => !chosen || chosen.includes(name));
  const [reason, seeder, source] = [
    allowed(header.reasons, now.reasons),
    allowed(header.seeders, now.seeders),
    allowed(header.sources, now.sources),
  ];
  const hits = bitsOf(header.barriers, now.barriers ?? []);
  const isHit = (k: number) => hits.some((bits, word) => (barriers[k * hits.length + word]! & bits) !== 0);
  const passes = new Uint8Array(reasons.length);
  for (let k = 0; k < passes.length; ++k) {
    const energy = maxEnergies[k]!;
    passes[k] = Number(
      reason[reasons[k]!] &&
        seeder[seeders[k]!] &&
        source[sources[k]!] &&
        (!starts || !releases || starts.has(releases[k]!)) &&
        (now.crossing === null || !crossing || crossing.has(rocks.rocks[k]!)) &&
        (now.barriers === null || isHit(k)) &&
        (now.minEnergy_kJ === null || energy >= now.minEnergy_kJ) &&
        (now.maxEnergy_kJ === null || energy <= now.maxEnergy_kJ),
    );
  }
  return passes;
}
