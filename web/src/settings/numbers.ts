// Parsing of typed numbers.

import type { TomlValue } from '../toml/format';
import { jsonText } from '../toml/json';

const integerLimit = 2n ** 63n; // TOML integers have 64 bits

function wholeOf(digits: string): number | bigint | undefined {
  if (Number.isSafeInteger(Number(digits))) return Number(digits);
  const exact = BigInt(digits.replace(/^\+/, ''));
  return exact >= -integerLimit && exact < integerLimit ? exact : undefined;
}

/// Trimmed, with a hyphen for a typographic minus sign.
export const withMinus = (text: string) => text.trim().replace(/^\u2212/, '-');
export const isNumeral = (text: string) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(withMinus(text));

/// A number for the project file. Undefined if the text is not a number, or one that would overflow, underflow to 0, or
/// become another integer.
export function numberOf(text: string): number | bigint | undefined {
  const bare = withMinus(text);
  if (/^[+-]?inf$/.test(bare)) return bare.startsWith('-') ? -Infinity : Infinity;
  if (/^[+-]?\d+$/.test(bare)) return wholeOf(bare);
  if (!isNumeral(bare)) return undefined;
  const number = Number(bare);
  const isLost = number === 0 && /[1-9]/.test(bare.replace(/e.*/i, ''));
  return isLost || !Number.isFinite(number) ? undefined : number;
}

/// The value of a typed text: a number, or the text itself, which the engine then reports. Undefined if it is empty.
export function typedValue(text: string): TomlValue | undefined {
  const bare = text.trim();
  return bare === '' ? undefined : (numberOf(bare) ?? bare);
}

/// "1,250" may be 1.25 or 1250.
const mayHaveThousands = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/// The value of a typed text in the field of a number, where a decimal comma is accepted.
export function typedNumber(text: string): TomlValue | undefined {
  const bare = withMinus(text);
  const point = bare.replace(',', '.');
  return typedValue(isNumeral(point) && !mayHaveThousands.test(bare) ? point : text);
}

/// Numbers separated by commas, semicolons or spaces. If there are other separators, a comma between digits counts as a
/// decimal comma; the engine then reports how to write the number.
export function typedList(text: string): TomlValue[] {
  const hasDecimals = /\d,\d/.test(text) && /[;\s]/.test(text.trim());
  const parts = text.split(hasDecimals ? /,(?!\d)|(?<!\d),|[;\s]/ : /[,;\s]/);
  return parts.flatMap((part) => typedValue(part) ?? []);
}

export function cellText(value: unknown): string {
  if (value === undefined || value === null) return '';
  if (value === Infinity) return 'inf';
  if (value === -Infinity) return '-inf';
  return typeof value === 'object' ? jsonText(value) : String(value);
}
