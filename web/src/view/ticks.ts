// Round numbers for axes, contours and scale bars.

/// The least of 1, 2 and 5 times a power of ten that is at least `least`.
export function roundStep(least: number): number {
  if (!(least > 0) || !Number.isFinite(least)) return 1;
  const power = 10 ** Math.floor(Math.log10(least) + 1e-9);
  const lead = least / power;
  return power * (lead <= 1.000001 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
}

/// The next number with two digits that count: 123 is 130.
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
