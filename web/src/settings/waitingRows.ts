// Incomplete rows of an edit table. Complete rows are stored in the project; incomplete ones wait between them.

import type { TomlValue } from '../toml/format';
import { typedValue } from './numbers';
import { rowValue } from './rows';

type Cells = readonly string[];

export interface Waiting {
  /// The index in the table.
  at: number;
  cells: Cells;
  /// The row that is being changed, which the project keeps until this one is complete; null for a new row.
  replaces: Cells | null;
}

/// A row of the table.
export interface Row {
  cells: Cells;
  /// The row in the project; null if the project does not have it.
  given: Cells | null;
}

export const isBlank = (cells: Cells) => cells.every((cell) => cell.trim() === '');
export const isSameRow = (a: Cells | null, b: Cells | null) =>
  a === b || (a !== null && b !== null && a.length === b.length && a.every((cell, k) => cell === b[k]));

/// The rows of the project together with waiting rows. A waiting row is dropped if the row that it replaces has changed.
export function withWaiting(given: readonly Cells[], waiting: readonly Waiting[]): Row[] {
  const rows: Row[] = [];
  let next = 0;
  const takeUpTo = (end: number) => {
    while (next < given.length && rows.length < end) {
      const cells = given[next++]!;
      rows.push({ cells, given: cells });
    }
  };
  for (const { at, cells, replaces } of waiting) {
    takeUpTo(at);
    if (replaces === null) rows.push({ cells, given: null });
    else if (isSameRow(replaces, given[next] ?? null)) rows.push({ cells, given: given[next++]! });
  }
  takeUpTo(Infinity);
  return rows;
}

/// The zero-based index in the project of each row of the table; null if the project does not have it.
export function placesInProject(rows: readonly Row[]): (number | null)[] {
  let next = 0;
  return rows.map(({ given }) => (given === null ? null : next++));
}
/// The index in the table of a row of the project.
export function placeInTable(waiting: readonly Waiting[], number: number): number {
  return waiting.reduce((at, { at: own, replaces }) => (replaces === null && own <= at ? at + 1 : at), number);
}

/// The value of a row that the project has.
export const asGiven = (cells: Cells): TomlValue[] =>
  cells.slice(0, cells.findLastIndex((cell) => cell.trim() !== '') + 1).map((cell) => typedValue(cell) ?? '');

/// The rows of a table that the project stores, and those that wait.
export function settled(rows: readonly Row[], least: number): { rows: TomlValue[][]; waiting: Waiting[] } {
  const taken: TomlValue[][] = [];
  const waiting: Waiting[] = [];
  rows.forEach(({ cells, given }, at) => {
    const value = rowValue(cells, least) ?? (given && asGiven(given));
    if (value) taken.push(value);
    if (!rowValue(cells, least) && !isSameRow(cells, given)) waiting.push({ at, cells, replaces: given });
  });
  return { rows: taken, waiting };
}

/// One-based row numbers: "row 4", "rows 3, 7 and 12".
export function rowsText(waiting: readonly Waiting[]): string {
  const numbers = waiting.map(({ at }) => at + 1);
  const last = numbers.pop();
  return numbers.length === 0 ? `row ${last}` : `rows ${numbers.join(', ')} and ${last}`;
}

/// Sentences about incomplete rows, without empty ones.
export function sentencesOf(waiting: readonly Waiting[]): string[] {
  const typed = waiting.filter(({ cells }) => !isBlank(cells));
  const sentence = (rows: Waiting[], ending: string) => {
    if (rows.length === 0) return [];
    const subject = rowsText(rows);
    return [`R${subject.slice(1)} ${rows.length === 1 ? 'is' : 'are'} incomplete${ending}`];
  };
  return [
    ...sentence(typed.filter(({ replaces }) => !replaces), ' and not part of the project yet.'),
    ...sentence(typed.filter(({ replaces }) => replaces), '; the project keeps the previous values.'),
  ];
}
