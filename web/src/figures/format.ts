// Numbers for reading, the same in figures, tables and text: as many digits as they deserve, thousands set apart, a
// true minus sign. Files keep all digits.

const missing = '–';
const withMinus = (text: string) => text.replace('-', '−');

/// With so many decimals at most.
const rounded = (value: number, decimals: number) =>
  withMinus((Number(value.toFixed(decimals)) || 0).toLocaleString('en-US', { maximumFractionDigits: decimals }));

const firstDecimal = (size: number) => -Math.floor(Math.log10(size));
const isWhole = (value: number) => Number.isInteger(value) && Math.abs(value) < 1e15;

/// With so many digits that count; whole numbers with all, very small and very large ones in powers of ten.
export function numberText(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return missing;
  const size = Math.abs(value);
  if (isWhole(value)) return rounded(value, 0);
  if (size < 1e-4 || size >= 1e15) return withMinus(Number(value.toPrecision(digits)).toExponential());
  return rounded(value, Math.min(Math.max(digits - 1 + firstDecimal(size), 0), 9));
}

/// A result: so many digits, and none beyond a thousandth of its unit but the first one. Less than a millionth is what
/// is left of rounding.
export function measured(value: number, digits = 4): string {
  if (!Number.isFinite(value) || isWhole(value)) return numberText(value, digits);
  const first = firstDecimal(Math.abs(value));
  return rounded(value, first > 6 ? 0 : first > 3 ? first : Math.min(Math.max(digits - 1 + first, 0), 3));
}

/// With so many decimals; nothing is not below zero.
export function fixedText(value: number, decimals: number): string {
  const shown = Number(value.toFixed(decimals)) || 0;
  return withMinus(shown.toLocaleString('en-US', { minimumFractionDigits: decimals, maximumFractionDigits: decimals }));
}

/// A number on an axis whose ticks are so far apart: no more decimals than these need.
export const tickText = (value: number, step: number) =>
  fixedText(value, Math.min(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), 9));

/// "1 rock", "1,234 rocks".
export const counted = (count: number, one: string, several = `${one}s`) =>
  `${numberText(count)} ${count === 1 ? one : several}`;
