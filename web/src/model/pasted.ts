// Rows of numbers as spreadsheets and files give them.

import { isNumeral, numberOf, withMinus } from './numbers';

/// What the commas of a text do: "1,250" is a thousand and more, little more than one, or two columns.
export type Commas = 'part thousands' | 'are decimal' | 'part columns';

export interface Pasted {
  rows: string[][];
  /// A number that the text leaves open, and what it may be; its cell stays as it is until somebody says.
  open: { number: string; readings: Commas[] } | null;
}

/// Numbers with thousands apart by a sign, and decimals behind the other one.
const numberWith = (thousands: string, decimal: string) =>
  new RegExp(`^[+-]?(\\d+|[1-9]\\d{0,2}(${thousands}\\d{3})+)(${decimal}\\d*)?(e[+-]?\\d+)?$`, 'i');
const [withComma, withPoint] = [numberWith('\\.', ','), numberWith(',', '\\.')];
const isNumber = (cell: string) =>
  isNumeral(cell) || numberOf(cell) !== undefined || withComma.test(cell) || withPoint.test(cell);
const [groupedByCommas, groupedByPoints] = [/^[+-]?[1-9]\d{0,2}(,\d{3})+$/, /^[+-]?[1-9]\d{0,2}(\.\d{3})+$/];
const decimalComma = /^[+-]?\d+,\d+(e[+-]?\d+)?$/i;

/// The decimal sign that a number tells, when it can be no other.
function decimalSignOf(cell: string): '.' | ',' | null {
  const signs = cell.replace(/[^.,]/g, '');
  if (groupedByCommas.test(cell)) return signs.length > 1 ? '.' : null;
  if (groupedByPoints.test(cell)) return signs.length > 1 ? ',' : null;
  if (signs.endsWith(',') && withComma.test(cell)) return ',';
  return signs.endsWith('.') && withPoint.test(cell) ? '.' : null;
}

/// Cells as the project writes numbers: with a point, and nothing between thousands. What is said of one cell holds for
/// all: they come from one program.
function withPoints(cells: string[][], commas: Commas | undefined): Pasted {
  const told = new Set(cells.flat().map(decimalSignOf));
  const [tellsComma, tellsPoint] = [told.has(','), told.has('.')];
  const known = commas ?? (tellsComma === tellsPoint ? undefined : tellsComma ? 'are decimal' : 'part thousands');
  const read = (cell: string) => {
    if (known === 'part thousands' && withPoint.test(cell)) return cell.replaceAll(',', '');
    if (known === 'are decimal' && !tellsPoint && withComma.test(cell))
      return cell.replaceAll('.', '').replace(',', '.');
    const isDecimal = decimalComma.test(cell) && (known === 'are decimal' || !groupedByCommas.test(cell));
    return isDecimal ? cell.replace(',', '.') : cell;
  };
  const number = known ? undefined : cells.flat().find((cell) => groupedByCommas.test(cell));
  return {
    rows: cells.map((row) => row.map(read)),
    open: number === undefined ? null : { number, readings: ['part thousands', 'are decimal'] },
  };
}

/// What the commas may do where each line could be one number.
function readingsOf(lines: string[]): Commas[] {
  const mayBe = (number: RegExp) =>
    lines.length > 0 && lines.every((line) => number.test(line) || /^[+-]?\d+$/.test(line));
  const readings: Commas[] = [];
  if (mayBe(/^[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$/)) readings.push('part thousands');
  if (mayBe(decimalComma)) readings.push('are decimal');
  return readings.length > 0 ? [...readings, 'part columns'] : [];
}

/// The cells of a text that was copied from a spreadsheet or a file: columns apart by tabs, semicolons, commas or blanks.
/// With tabs or semicolons between them, numbers may have decimal commas. Lines without any number, such as a heading,
/// are left out.
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
  if (readings.length === 0 || commas === 'part columns') return { rows: cut(separator), open: null };
  const rows = column.map((line) => [line]);
  if (commas !== undefined) return { ...withPoints(rows, commas), open: null };
  const number = column.find((line) => line.includes(','))!;
  return { rows, open: { number, readings } };
}

/// Without headings.
function numberRows(cells: string[][]): string[][] {
  const rows = cells.filter((row) => row.some(isNumber));
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
