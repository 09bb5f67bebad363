// The classes in which maps are shown. They are fixed, so that the maps of two runs compare.

import type { Colour } from '../view/colours';

export interface MapClass {
  /// Values from here up to, but not, `to`, in the unit in which the map is read; null: without end.
  from: number;
  to: number | null;
  colour: Colour;
}

/// Of a value's class, its place in the list.
export function classOf(classes: readonly MapClass[], value: number): number {
  const after = classes.findIndex(({ to }) => to === null || value < to);
  return after < 0 ? classes.length - 1 : after;
}

/// As a legend has it: "< 30", "30 – 100", "≥ 3,000".
export function classText({ from, to }: MapClass, isFirst: boolean): string {
  const text = (value: number) => (value >= 1e4 || value === 0 || value >= 0.001 ? value.toLocaleString('en', { maximumSignificantDigits: 6 }) : value.toExponential(0).replace('-', '−'));
  if (to === null) return `≥ ${text(from)}`;
  return isFirst ? `< ${text(to)}` : `${text(from)} – ${text(to)}`;
}
