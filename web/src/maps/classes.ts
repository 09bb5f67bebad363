// The classes of maps. They are fixed, so that maps of different runs can be compared.

import type { Colour } from '../view/colours';

export interface MapClass {
  /// Values from `from` up to, but excluding, `to`, in the displayed unit; null: no upper limit.
  from: number;
  to: number | null;
  colour: Colour;
}

/// The index of a value's class.
export function classOf(classes: readonly MapClass[], value: number): number {
  const after = classes.findIndex(({ to }) => to === null || value < to);
  return after < 0 ? classes.length - 1 : after;
}

/// The text in a legend: "< 30", "30 – 100", "≥ 3,000".
export function classText({ from, to }: MapClass, isFirst: boolean): string {
  const text = (value: number) => (value >= 1e4 || value === 0 || value >= 0.001 ? value.toLocaleString('en', { maximumSignificantDigits: 4 }) : value.toExponential(0).replace('-', '−'));
  if (to === null) return `≥ ${text(from)}`;
  return isFirst ? `< ${text(to)}` : `${text(from)} – ${text(to)}`;
}
