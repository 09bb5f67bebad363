// The answers to what if as bars of a tornado, and as rows of a table: each change with its interval.

import type { Interval } from '../api/line';
import { modelFactor, type Change, type Variation, type WhatIfAnswer, type WhatIfFigure } from '../api/whatIf';
import { measured } from '../units/numbers';
import type { TornadoBar } from '../figures/tornado';
import type { Edit } from '../settings/names';
import { tableOf } from '../settings/declared';
import { wordText } from '../settings/words';
import type { Displayed } from '../units/units';

/// The unit is that of the files.
export const figures: Record<WhatIfFigure, { title: string; unit: string }> = {
  share: { title: 'share', unit: 'share' },
  energy_J: { title: 'energy', unit: 'J' },
  height_m: { title: 'height', unit: 'm' },
  velocity_m_s: { title: 'velocity', unit: 'm/s' },
};

/// A change of a share is in points, because "+10 %" of a share could also mean a tenth of it.
export const changeIn = (by: WhatIfFigure, display: Displayed): Displayed => (by === 'share' ? { ...display, unit: `${display.unit} points` } : display);

/// "95 % total energy": the energy is that which the check takes.
export const figureTitle = (by: WhatIfFigure, { percentile, energy }: Pick<WhatIfAnswer, 'percentile' | 'energy'>) =>
  by === 'share' ? 'Share' : `${percentile} % ${by === 'energy_J' ? `${energy} ` : ''}${figures[by].title}`;

/// "Roughness +25 %", "Rock model: rigid sphere"
export const nameOf = ({ title, step_percent: step, model }: Pick<Variation, 'title' | 'step_percent' | 'model'>) =>
  step === null ? `${title}: ${wordText(model ?? '')}` : `${title} ${step < 0 ? '−' : '+'}${Math.abs(step)} %`;

/// A bar that knows its variation.
export interface WhatIfBar extends TornadoBar {
  variation: Variation;
}

const barOf = (variation: Variation, by: WhatIfFigure, { per }: Displayed): WhatIfBar | null => {
  const found = variation.difference[by];
  if (!found) return null;
  const [value, low, high] = found.map((each) => (each === null ? null : each / per));
  return { name: nameOf(variation), value: value!, low: low ?? null, high: high ?? null, variation };
};

/// A row for each factor, that with the largest change on top; the step down is above the step up.
export function barsOf({ variations }: WhatIfAnswer, by: WhatIfFigure, display: Displayed): WhatIfBar[] {
  const rows: WhatIfBar[] = [];
  for (const factor of new Set(variations.map((each) => each.factor))) {
    const [first, second] = variations
      .filter((each) => each.factor === factor)
      .toSorted((a, b) => (a.step_percent ?? 0) - (b.step_percent ?? 0))
      .flatMap((each) => barOf(each, by, display) ?? []);
    if (factor === modelFactor) rows.push(...[first, second].filter((bar) => bar !== undefined));
    else if (first) rows.push(second ? { ...first, other: second, row: first.variation.title } : first);
  }
  const size = ({ value, other }: TornadoBar) => Math.max(Math.abs(value), Math.abs(other?.value ?? 0));
  return rows.toSorted((a, b) => size(b) - size(a));
}

const signed = (value: number) => (value > 0 ? `+${measured(value, 3)}` : measured(value, 3));

/// "+4.2 (+3.6 to +4.8) kJ"; with few rocks without the interval.
export function changeText(change: Interval | null, { unit, per }: Displayed): string {
  if (!change) return 'no rock crosses';
  const [value, low, high] = change.map((each) => (each === null ? null : signed(each / per)));
  return low === null || high === null ? `${value} ${unit}` : `${value} (${low} to ${high}) ${unit}`;
}

/// The changes of a variation as edits of the run's project.
export const editsOf = (changes: readonly Change[]): Edit[] =>
  changes.map(({ path: [table, row, key], after }) => {
    const path = (tableOf(table)?.repeated === false ? [table, key] : [table, row, key]) as unknown as Extract<Edit, { set: unknown }>['set'];
    return after === null || after === undefined ? { remove: path } : { set: path, value: after as never };
  });
