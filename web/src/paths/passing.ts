// Which rocks a filter leaves.

import type { RockFilter } from '../state/filter';
import type { DrawnPaths } from './drawnPaths';

type Rocks = Pick<DrawnPaths, 'reasons' | 'seeders' | 'sources' | 'barriers' | 'maxEnergies'> & {
  header: Pick<DrawnPaths['header'], 'reasons' | 'seeders' | 'sources' | 'barriers'>;
};

/// 1 for a rock that passes, 0 for one that does not.
export function passing(rocks: Rocks, now: RockFilter): Uint8Array {
  const { header, reasons, seeders, sources, barriers, maxEnergies } = rocks;
  const allowed = (names: string[], chosen: string[] | null) => names.map((name) => !chosen || chosen.includes(name));
  const [reason, seeder, source] = [
    allowed(header.reasons, now.reasons),
    allowed(header.seeders, now.seeders),
    allowed(header.sources, now.sources),
  ];
  const hits = header.barriers.reduce((bits, name, k) => (now.barriers?.includes(name) && k < 32 ? bits | (1 << k) : bits), 0);
  const passes = new Uint8Array(reasons.length);
  for (let k = 0; k < passes.length; ++k) {
    const energy = maxEnergies[k]!;
    passes[k] = Number(
      reason[reasons[k]!] &&
        seeder[seeders[k]!] &&
        source[sources[k]!] &&
        (now.barriers === null || (barriers[k]! & hits) !== 0) &&
        (now.minEnergy_kJ === null || energy >= now.minEnergy_kJ) &&
        (now.maxEnergy_kJ === null || energy <= now.maxEnergy_kJ),
    );
  }
  return passes;
}
