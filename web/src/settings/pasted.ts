// Reads rows of numbers pasted from spreadsheets and files.

import { isNumeral, numberOf, withMinus } from './numbers';

/// The role of commas: "1,250" may be 1250, 1.25, or the two columns 1 and 250.
export type Commas = 'separate thousands' | 'are decimal' | 'separate columns';

export interface Pasted {
  rows: string[][];
  /// An ambiguous number and its possible readings; null if there is none. Its cell stays as it is.
  open: { number: string; readings: Commas[] } | null;
}

/// A pattern for numbers with a thousands separator and a decimal separator.
const numberWith = (thousands: string, decimal: string) =>
  new RegExp(`^[+-]?(\\d+|[1-9]\\d{0,2}(${thousands}\\d{3})+)(${decimal}\\d*)?(e[+-]?\\d+)?$`, 'i');
const [withComma, withPoint] = [numberWith('\\.', ','), numberWith(',', '\\.')];
const isNumber = (cell: string) =>
  isNumeral(cell) || numberOf(cell) !== undefined || withComma.test(cell) || withPoint.test(cell);
const [groupedByCommas, groupedByPoints] = [/^[+-]?[1-9]\d{0,2}(,\d{3})+$/, /^[+-]?[1-9]\d{0,2}(\.\d{3})+$/];
const decimalComma = /^[+-]?\d+,\d+(e[+-]?\d+)?$/i;

/// The decimal separator of a number; null if it is ambiguous.
function decimalSignOf(cell: string): '.' | ',' | null {
  const signs = cell.replace(/[^.,]/g, '');
  if (groupedByCommas.test(cell)) return signs.length > 1 ? '.' : null;
  if (groupedByPoints.test(cell)) return signs.length > 1 ? ',' : null;
  if (signs.endsWith(',') && withComma.test(cell)) return ',';
  return signs.endsWith('.') && withPoint.test(cell) ? '.' : null;
}

/// Converts cells to numbers with a decimal point and no thousands separators. All cells come from one program, so one
/// unambiguous number decides for all.
function withPoints(cells: string[][], commas: Commas | undefined): Pasted {
  const signs = new Set(cells.flat().map(decimalSignOf));
  const [hasComma, hasPoint] = [signs.has(','), signs.has('.')];
  const known = commas ?? (hasComma === hasPoint ? undefined : hasComma ? 'are decimal' : 'separate thousands');
  const read = (cell: string) => {
    if (known === 'separate thousands' && withPoint.test(cell)) return cell.replaceAll(',', '');
    if (known === 'are decimal' && !hasPoint && withComma.test(cell))
      return cell.replaceAll('.', '').replace(',', '.');
    const isDecimal = decimalComma.test(cell) && (known === 'are decimal' || !groupedByCommas.test(cell));
    return isDecimal ? cell.replace(',', '.') : cell;
  };
  const number = known ? undefined : cells.flat().find((cell) => groupedByCommas.test(cell));
  return {
    rows: cells.map((row) => row.map(read)),
    open: number === undefined ? null : { number, readings: ['separate thousands', 'are decimal'] },
  };
}

/// The possible roles of commas if every line could be one number.
function readingsOf(lines: string[]): Commas[] {
  const mayBe = (number: RegExp) =>
    lines.length > 0 && lines.every((line) => number.test(line) || /^[+-]?\d+$/.test(line));
  const readings: Commas[] = [];
  if (mayBe(/^[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$/)) readings.push('separate thousands');
  if (mayBe(decimalComma)) readings.push('are decimal');
  return readings.length > 0 ? [...readings, 'separate columns'] : [];
}

/// The cells of a text copied from a spreadsheet or a file, with columns separated by tabs, semicolons, commas or spaces.
/// Between tabs or semicolons, numbers may have decimal commas. Lines without a number, such as headings, are skipped.
export function readPasted(text: string, commas?: Commas): Pasted {
  const lines = text.split(/\r\n|\r|\n/).filter((line) => line.trim() !== '');
  const separator = [/\t/, /;/, /,/].find((candidate) => lines.some((line) => candidate.test(line)));
  const unquoted = (cell: string) => withMinus(cell.trim().replace(/^"(.*)"$/, '$1'));
  const cut = (by: RegExp | undefined) =>
    numberRows(lines.map((line) => (by ? line.split(by) : line.trim().split(/\s+/)).map(unquoted)));
  if (separator === undefined) return { rows: cut(undefined), open: null };
  if (separator.source !== ',') return withPoints(cut(separator), commas);
  const column = lines.map(unquoted).filter((line) => /\d/.test(line));
  const readings = readingsOf(column);
  if (readings.length === 0 || commas === 'separate columns') return { rows: cut(separator), open: null };
  const rows = column.map((line) => [line]);
  if (commas !== undefined) return { ...withPoints(rows, commas), open: null };
  const number = column.find((line) => line.includes(','))!;
  return { rows, open: { number, readings } };
}

/// Drops headings.
function numberRows(cells: string[][]): string[][] {
  const rows = cells.filter((row) => row.some(isNumber));
  // A comma at the end of each line leaves an empty last column.
  return rows.every((row) => row.length > 1 && row.at(-1) === '') ? rows.map((row) => row.slice(0, -1)) : rows;
}

/// Drops a first column of names or row numbers, as in printed tables of vertices.
export function withoutNames(rows: string[][], columns: number): string[][] {
  const named = rows.length > 0 && rows.every((row) => row.length === columns + 1);
  const isCounted =
    named &&
    rows.every((row, k) => numberOf(row[0]!) === undefined || (numberOf(row[0]!) === k + 1 && rows.length > 1));
  return isCounted ? rows.map((row) => row.slice(1)) : rows;
}
