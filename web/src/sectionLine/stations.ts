// Lines across a section, at which its envelopes are asked for.

import type { LineQuantity, StationAnswer } from '../api/line';
import type { Point2 } from '../api/types';
import type { AlongLine } from '../figures/profile';
import type { Displayed } from '../units/units';

export interface Station {
  /// Along the section [m].
  distance: number;
  /// Across it, from left to right.
  line: [Point2, Point2];
}

/// `count` stations, evenly spaced along the line, half a spacing from its ends.
export function stationsAlong(line: readonly Point2[], halfWidth: number, count: number): Station[] {
  const pieces = line.slice(1).flatMap(([x, y], k) => {
    const [fromX, fromY] = line[k]!;
    const length = Math.hypot(x - fromX, y - fromY);
    return length > 0 ? [{ fromX, fromY, ux: (x - fromX) / length, uy: (y - fromY) / length, length }] : [];
  });
  const whole = pieces.reduce((sum, { length }) => sum + length, 0);
  const stations: Station[] = [];
  let [piece, way] = [0, 0];
  for (let k = 0; k < count && pieces.length > 0; ++k) {
    const distance = ((k + 0.5) * whole) / count;
    while (piece < pieces.length - 1 && way + pieces[piece]!.length < distance) way += pieces[piece++]!.length;
    const { fromX, fromY, ux, uy } = pieces[piece]!;
    const [x, y] = [fromX + (distance - way) * ux, fromY + (distance - way) * uy];
    stations.push({
      distance,
      line: [
        [x - halfWidth * uy, y + halfWidth * ux],
        [x + halfWidth * uy, y - halfWidth * ux],
      ],
    });
  }
  return stations;
}

/// Quantities of the envelopes (height of the block's top, total kinetic energy, velocity), with the unit of the answers.
export const envelopeChoices = {
  height_m: { title: "Height of the block's top", unit: 'm' },
  ke_total_J: { title: 'Total energy', unit: 'J' },
  velocity_m_s: { title: 'Velocity', unit: 'm/s' },
} as const satisfies Partial<Record<LineQuantity, { title: string; unit: string }>>;
export type EnvelopeChoice = keyof typeof envelopeChoices;

/// The maximum and the 95th percentile at the stations, as displayed.
export function envelopeOf(distances: readonly number[], answers: readonly StationAnswer[], of: EnvelopeChoice, { unit, per }: Displayed): AlongLine {
  const { title } = envelopeChoices[of];
  const shown = (value: number | null | undefined) => (value === null || value === undefined ? null : value / per);
  return {
    label: `${title} [${unit}]`,
    stations: distances,
    curves: [
      { name: `maximum ${title.toLowerCase()}`, dash: '', values: answers.map(({ whole }) => shown(whole?.maxima?.[of])) },
      { name: 'percentile 95', dash: '4 3', values: answers.map(({ whole }) => shown(whole?.percentiles[of]?.['95']?.[0])) },
    ],
  };
}
