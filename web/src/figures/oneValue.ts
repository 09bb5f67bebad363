// A readable axis for values that are all equal, except for rounding errors.

import { roundStep } from '../geometry/ticks';

export interface Ends {
  min: number;
  max: number;
  interval: number;
}

/// The ends of the axis around the value; null if the values differ.
export function endsAround(values: readonly number[]): Ends | null {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  if (values.length === 0 || !(high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) return null;
  const middle = (low + high) / 2;
  const step = roundStep(Math.min(Math.abs(middle) / 20 || 0.5, 1));
  const nearest = Math.round(middle / step);
  const at = (k: number) => Number(((nearest + k) * step).toPrecision(15));
  return { min: at(-2), max: at(2), interval: Number(step.toPrecision(6)) };
}
