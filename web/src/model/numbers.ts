// Numbers as people type them.

import type { TomlValue } from '../toml/format';
import { jsonText } from '../toml/json';

const mostWhole = 2n ** 63n; // TOML has whole numbers of 64 bits

function wholeOf(digits: string): number | bigint | undefined {
  if (Number.isSafeInteger(Number(digits))) return Number(digits);
  const exact = BigInt(digits.replace(/^\+/, ''));
  return exact >= -mostWhole && exact < mostWhole ? exact : undefined;
}

/// Trimmed, and with the minus that keyboards have.
export const withMinus = (text: string) => text.trim().replace(/^\u2212/, '-');
export const isNumeral = (text: string) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(withMinus(text));

/// A number as the project file writes it; undefined where the text is none, or one that the file cannot have: it would
/// become infinite, nothing, or another whole number.
export function numberOf(text: string): number | bigint | undefined {
  const bare = withMinus(text);
  if (/^[+-]?inf$/.test(bare)) return bare.startsWith('-') ? -Infinity : Infinity;
  if (/^[+-]?\d+$/.test(bare)) return wholeOf(bare);
  if (!isNumeral(bare)) return undefined;
  const number = Number(bare);
  const isLost = number === 0 && /[1-9]/.test(bare.replace(/e.*/i, ''));
  return isLost || !Number.isFinite(number) ? undefined : number;
}

/// What a typed text says: a number, or the text itself, which the engine then refuses in its own words. Nothing:
/// undefined.
export function typedValue(text: string): TomlValue | undefined {
  const bare = text.trim();
  return bare === '' ? undefined : (numberOf(bare) ?? bare);
}

/// "1,250" may be little more than one, or a thousand and more.
const mayPartThousands = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/// What is typed in the field of one number: a decimal comma is a point there.
export function typedNumber(text: string): TomlValue | undefined {
  const bare = withMinus(text);
  const point = bare.replace(',', '.');
  return typedValue(isNumeral(point) && !mayPartThousands.test(bare) ? point : text);
}

/// Numbers with commas, semicolons or blanks between them. Where something else parts them, too, a comma between digits
/// is a decimal one: its number goes to the engine as it is, which says how to write it.
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
