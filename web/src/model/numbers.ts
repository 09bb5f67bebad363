// Numbers as people type them, and rows of them as spreadsheets give them.

import type { TomlValue } from '../toml/format';
import { jsonText } from '../toml/json';

const mostWhole = 2n ** 63n; // TOML has whole numbers of 64 bits

function wholeOf(digits: string): number | bigint | undefined {
  if (Number.isSafeInteger(Number(digits))) return Number(digits);
  const exact = BigInt(digits.replace(/^\+/, ''));
  return exact >= -mostWhole && exact < mostWhole ? exact : undefined;
}

const plain = (text: string) => text.trim().replace(/^\u2212/, '-');
export const isNumeral = (text: string) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain(text));

/// A number as the project file writes it; undefined where the text is none, or one that the file cannot have: it would
/// become infinite, nothing, or another whole number.
export function numberOf(text: string): number | bigint | undefined {
  const bare = plain(text);
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

export function cellText(value: unknown): string {
  if (value === undefined || value === null) return '';
  if (value === Infinity) return 'inf';
  if (value === -Infinity) return '-inf';
  return typeof value === 'object' ? jsonText(value) : String(value);
}

/// The cells of a text that was copied from a spreadsheet or a file: columns apart by tabs, semicolons, commas or blanks.
/// With tabs or semicolons between them, numbers may have decimal commas. Lines without any number, such as a heading,
/// are left out.
export function pastedRows(text: string): string[][] {
  const lines = text.split(/\r\n|\r|\n/).filter((line) => line.trim() !== '');
  const separator = [/\t/, /;/, /,/].find((candidate) => lines.some((line) => candidate.test(line)));
  const unquoted = (cell: string) => plain(cell.trim().replace(/^"(.*)"$/, '$1'));
  const cells = lines.map((line) => (separator ? line.split(separator) : line.trim().split(/\s+/)).map(unquoted));
  const mayHaveCommas = separator !== undefined && separator.source !== ',';
  const points = cells.map((row) =>
    row.map((cell) => (mayHaveCommas && /^[+-]?\d+,\d+(e[+-]?\d+)?$/i.test(cell) ? cell.replace(',', '.') : cell)),
  );
  const rows = points.filter((row) => row.some((cell) => isNumeral(cell) || numberOf(cell) !== undefined));
  // An empty last column, as a comma at the end of each line leaves it.
  return rows.every((row) => row.length > 1 && row.at(-1) === '') ? rows.map((row) => row.slice(0, -1)) : rows;
}

/// The last columns of rows that begin with a number or a letter for each, as tables of vertices in print do.
export function withoutNames(rows: string[][], columns: number): string[][] {
  const named = rows.length > 0 && rows.every((row) => row.length === columns + 1);
  const isCounted =
    named &&
    rows.every((row, k) => numberOf(row[0]!) === undefined || (numberOf(row[0]!) === k + 1 && rows.length > 1));
  return isCounted ? rows.map((row) => row.slice(1)) : rows;
}
