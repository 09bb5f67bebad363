// Numbers for display in figures, tables and text: rounded, with thousands separators and a true minus sign. Saved files
// have all digits.

const missing = '–';
const withMinus = (text: string) => text.replace('-', '−');

/// With at most `decimals` decimals.
const rounded = (value: number, decimals: number) =>
  withMinus((Number(value.toFixed(decimals)) || 0).toLocaleString('en-US', { maximumFractionDigits: decimals }));

const firstDecimal = (size: number) => -Math.floor(Math.log10(size));
const isWhole = (value: number) => Number.isInteger(value) && Math.abs(value) < 1e15;

/// With `digits` significant digits. Whole numbers have all of them; very small and very large numbers an exponent.
export function numberText(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return missing;
  const size = Math.abs(value);
  if (isWhole(value)) return rounded(value, 0);
  if (size < 1e-4 || size >= 1e15) return withMinus(Number(value.toPrecision(digits)).toExponential());
  return rounded(value, Math.min(Math.max(digits - 1 + firstDecimal(size), 0), 9));
}

/// A result: `digits` significant digits and at most three decimals, except for the first significant digit. Anything
/// below a millionth is a rounding error and shown as 0.
export function measured(value: number, digits = 4): string {
  if (!Number.isFinite(value) || isWhole(value)) return numberText(value, digits);
  const first = firstDecimal(Math.abs(value));
  return rounded(value, first > 6 ? 0 : first > 3 ? first : Math.min(Math.max(digits - 1 + first, 0), 3));
}

/// With exactly `decimals` decimals, without a negative zero.
export function fixedText(value: number, decimals: number): string {
  const shown = Number(value.toFixed(decimals)) || 0;
  return withMinus(shown.toLocaleString('en-US', { minimumFractionDigits: decimals, maximumFractionDigits: decimals }));
}

/// A number on an axis with ticks at intervals of `step`, with the decimals that these need.
export const tickText = (value: number, step: number) =>
  fixedText(value, Math.min(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), 9));

/// "1 rock", "1,234 rocks".
export const counted = (count: number, one: string, several = `${one}s`) =>
  `${numberText(count)} ${count === 1 ? one : several}`;
