// Texts and cells of a barrier design.

import type { DesignOf, NeedsOf, PairKitOf, ShareOf } from '../archive/summary';
import { givenIn, givenLength, isNumber, number, resultIn, unitIn } from './format';
import { listOf, type Run } from './run';
import type { BodyCell } from './tables';

export type Design = DesignOf<number>;
export type Line = Design['lines'][number];
export type Section = Line['sections'][number];
export type Kit = Design['ranking'][number];
export type Pair = NonNullable<Design['pairs']>[number];
type Share = ShareOf<number> | null | undefined;
/// A percentile with its interval; undefined: there is none.
export type Percentile = Line['percentiles'][string][string] | undefined;

/// A run with a design.
export interface DesignRun {
  run: Run;
  design: Design;
}

export const percentText = (share: number, digits?: number) => `${number(100 * share, digits)} %`;
export const shareText = (share: Share) => (share ? percentText(share.value, 3) : '–');
export const shareRange = ({ low, high }: ShareOf<number>) => `${number(100 * low, 3)} to ${percentText(high, 3)}`;
export const shareCell = (share: Share): string | BodyCell =>
  share ? { text: shareText(share), below: shareRange(share) } : '–';

const endIn = (unit: string, end: number | null) => (isNumber(end) ? resultIn(unit, end) : '…');
export function percentileCell(percentile: Percentile, unit: string): string | BodyCell {
  if (!percentile) return '–';
  const [value, low, high] = percentile;
  return { text: resultIn(unit, value), below: `${endIn(unit, low)} to ${endIn(unit, high)}` };
}
export function percentileText([value, low, high]: NonNullable<Percentile>, unit: string): string {
  return `${resultIn(unit, value)} (${endIn(unit, low)} to ${endIn(unit, high)}) ${unitIn(unit)}`;
}

export const knownLength = (metres: number | null | undefined) => resultIn('m', metres, 3);
export const stretchText = ({ from_m, to_m }: Section) => `${givenIn('m', from_m, 5)} to ${givenLength(to_m, 5)}`;
export const givenEnergy = (joules: number) => `${givenIn('J', joules)} ${unitIn('J')}`;
export const lengthHead = (text: string) => ({ text, unit: unitIn('m') });
export const energyHead = (text: string) => ({ text, unit: unitIn('J') });

export const classText = (kitClass: number | null | undefined) => (isNumber(kitClass) ? String(kitClass) : '–');
/// Energy, class and height.
export const needsCells = (needs: NeedsOf<number> | null): string[] => [
  resultIn('J', needs?.energy_J),
  classText(needs?.class),
  knownLength(needs?.height_m),
];

interface Sufficing {
  suffices: boolean;
  sure: boolean;
  limited_by?: string | null;
}
export function sufficesText({ suffices, sure, limited_by }: Sufficing): string {
  const text = suffices ? 'yes' : limited_by ? `no: ${limited_by}` : 'no';
  return sure === false ? `${text}, uncertain` : text;
}
/// "Kit, 4 m, 1,000 kJ", without the name of a kit that has none.
export const kitText = ({ kit, height_m, energy_J }: PairKitOf<number>) =>
  `${kit ? `${kit}, ` : ''}${givenLength(height_m)}, ${givenEnergy(energy_J)}`;

export const isPriced = (run: Run) => listOf(run, 'kit').some(({ cost_per_m }) => isNumber(cost_per_m));
export const costTitle = (run: Run) => (isPriced(run) ? 'Cost' : 'Cost index');
export const confidenceText = ({ confidence }: Design) => `${percentText(confidence)} confidence interval`;
export const energyWord = ({ factors }: Design) => (factors.of_total_energy ? 'total kinetic' : 'translational');

/// Quantities by their names in the summary; the energy is the one that the check uses.
export function designQuantities({ factors }: Design) {
  const energy = factors.of_total_energy
    ? { key: 'ke_total_J', text: 'Total kinetic energy' }
    : { key: 'ke_translational_J', text: 'Translational energy' };
  return [
    { ...energy, unit: 'J' },
    { key: 'velocity_m_s', text: 'Velocity', unit: 'm/s' },
    { key: 'height_m', text: "Height of the block's top above the foot", unit: 'm' },
  ];
}

/// Names of the percentiles of a line or section.
export const percentilesIn = ({ percentiles }: Pick<Line, 'percentiles'>) =>
  Object.keys(Object.values(percentiles)[0] ?? {});
