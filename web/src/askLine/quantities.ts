// The quantities of the card and of the profile.

import type { LineFigures, LineQuantity } from '../api/line';
import type { Stretch } from '../figures/lineProfile';

export type ProfileChoice = 'rocks' | 'share' | LineQuantity;
interface Choice {
  title: string;
  /// Of the answers.
  unit: string;
  of: (figures: LineFigures, percentile: string) => [number, number | null, number | null] | null;
}

const percentileOf =
  (key: LineQuantity): Choice['of'] =>
  ({ percentiles }, percentile) =>
    percentiles[key]?.[percentile] ?? null;

/// By the percentile of the design.
export const profileChoices: Record<ProfileChoice, Choice> = {
  ke_translational_J: { title: 'Translational energy', unit: 'J', of: percentileOf('ke_translational_J') },
  ke_total_J: { title: 'Total energy', unit: 'J', of: percentileOf('ke_total_J') },
  velocity_m_s: { title: 'Velocity', unit: 'm/s', of: percentileOf('velocity_m_s') },
  height_m: { title: "Height of the block's top", unit: 'm', of: percentileOf('height_m') },
  rocks: { title: 'Rocks', unit: '', of: ({ rocks }) => [rocks, null, null] },
  share: { title: 'Share of all rocks', unit: 'share', of: ({ share }) => share && [share.value, share.low, share.high] },
};

export const hasPercentile = (of: ProfileChoice) => of !== 'rocks' && of !== 'share';

export function stretchesOf(sections: readonly LineFigures[], by: ProfileChoice, percentile: number): Stretch[] {
  return sections.map((figures) => {
    const [value, low, high] = profileChoices[by].of(figures, String(percentile)) ?? [null, null, null];
    return { from: figures.from_m, to: figures.to_m, rocks: figures.rocks, value, low, high };
  });
}
