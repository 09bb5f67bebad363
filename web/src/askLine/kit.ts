// What a kit would stop, looked up in the table that the answer has.

import type { KitTable, Share } from '../api/line';
import { numberText } from '../units/numbers';

/// The index of the value nearest to `wanted`.
export function nearestIndex(values: readonly number[], wanted: number): number {
  let best = 0;
  values.forEach((value, k) => {
    if (Math.abs(value - wanted) < Math.abs(values[best]! - wanted)) best = k;
  });
  return best;
}

export interface KitShare extends Share {
  height_m: number;
  energy_kJ: number;
  stopped: number;
}

/// The entry of the table for a height and an energy by their indices; null if no rock crosses.
export function kitShare(table: KitTable, height: number, energy: number): KitShare | null {
  const [value, low, high] = [table.share, table.low, table.high].map((rows) => rows[height]?.[energy] ?? null);
  if (typeof value !== 'number' || typeof low !== 'number' || typeof high !== 'number') return null;
  const stopped = table.stopped[height]![energy]!;
  return { height_m: table.heights_m[height]!, energy_kJ: table.energies_kJ[energy]!, stopped, value, low, high };
}

/// "93.1 %". Close to 0 and 100 % with as many decimals as it takes to differ from them. Halves are rounded up: 1,905 of
/// 2,000 are 95.3 %, as people and the engine have it.
export function percentText(share: number): string {
  const percent = 100 * share;
  const gap = Math.min(percent, 100 - percent);
  const decimals = gap <= 0 ? 0 : gap >= 0.1 ? 1 : Math.min(6, Math.ceil(-Math.log10(gap)) + 1);
  const byRounding = 1e-9; // of shares of rocks, whose halves are seldom exact numbers
  const rounded = Math.floor(percent * 10 ** decimals + 0.5 + byRounding) / 10 ** decimals;
  return `${rounded.toLocaleString('en-US', { maximumFractionDigits: decimals })} %`;
}
export const intervalText = ({ low, high }: Share): string => `${percentText(low).replace(' %', '')} to ${percentText(high)}`;

/// "5 m and 3,000 kJ here stop 93.1 % (91.4 to 94.6 %) of the rocks that cross".
export const kitSentence = (kit: KitShare): string =>
  `${numberText(kit.height_m)} m and ${numberText(kit.energy_kJ)} kJ here stop ${percentText(kit.value)} (${intervalText(kit)}) of the rocks that cross`;
