// Texts and saved rows of a ground section.

import type { GroundSection } from '../api/types';
import type { Cell } from '../figures/files';
import type { AlongLine } from '../figures/profile';

export function placeText({ distance_m, z_m, x_m, y_m }: GroundSection, k: number, between = ', '): string {
  const z = z_m[k];
  return [
    `${distance_m[k]!.toFixed(2)} m along`,
    typeof z === 'number' ? `z ${z.toFixed(2)} m` : 'no terrain from here',
    `x ${x_m[k]!.toFixed(2)} y ${y_m[k]!.toFixed(2)} m`,
  ].join(between);
}

/// Rows with all digits. An empty elevation means no terrain from there to the next point.
export function sectionRows({ distance_m, z_m, x_m, y_m }: GroundSection): Cell[][] {
  return [
    ['distance_m', 'z_m', 'x_m', 'y_m'],
    ...distance_m.map((distance, k) => [distance, z_m[k] ?? '', x_m[k]!, y_m[k]!]),
  ];
}

/// The envelope at its stations, in the units of its axis. Empty: nothing passes.
export function envelopeRows({ label, stations, curves }: AlongLine): Cell[][] {
  return [
    ['distance_m', ...curves.map(({ name }) => `${name} ${/\[.*\]/.exec(label)?.[0] ?? ''}`.trim())],
    ...stations.map((distance, k) => [distance, ...curves.map(({ values }) => values[k] ?? '')]),
  ];
}
