// Round numbers for axes, contours and scale bars.

/// The smallest 1, 2 or 5 times a power of ten that is at least `minimum`.
export function roundStep(minimum: number): number {
  if (!(minimum > 0) || !Number.isFinite(minimum)) return 1;
  const power = 10 ** Math.floor(Math.log10(minimum) + 1e-9);
  const lead = minimum / power;
  return power * (lead <= 1.000001 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
}

/// Rounds up to two significant digits: 130 for 123.
export function roundUp(value: number): number {
  if (!(value > 0)) return 0;
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1);
  return Number((unit * Math.ceil(value / unit - 1e-9)).toPrecision(2));
}

/// The multiples of `step` from `low` to `high`.
export function ticks(low: number, high: number, step: number): number[] {
  const list: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) list.push(k * step);
  return list;
}
