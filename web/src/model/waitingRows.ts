// Rows of an edit table that are typed but not complete. What is complete is taken; they wait between it.

import type { TomlValue } from '../toml/format';
import { typedValue } from './numbers';
import { rowValue } from './rows';

type Cells = readonly string[];

export interface Waiting {
  /// Its place in the table.
  at: number;
  cells: Cells;
  /// The row that is being changed: the project keeps it until this one is complete. Null: it is a new one.
  over: Cells | null;
}

/// A row as a table shows it.
export interface Row {
  cells: Cells;
  /// As the project has it; null: the project does not have it.
  given: Cells | null;
}

export const isBlank = (cells: Cells) => cells.every((cell) => cell.trim() === '');
export const isSameRow = (a: Cells | null, b: Cells | null) =>
  a === b || (a !== null && b !== null && a.length === b.length && a.every((cell, k) => cell === b[k]));

/// The rows of the project with those that wait at their places. Who changes a row that is another one by now is not
/// waited for.
export function withWaiting(given: readonly Cells[], waiting: readonly Waiting[]): Row[] {
  const rows: Row[] = [];
  let next = 0;
  const takeUpTo = (end: number) => {
    while (next < given.length && rows.length < end) {
      const cells = given[next++]!;
      rows.push({ cells, given: cells });
    }
  };
  for (const { at, cells, over } of waiting) {
    takeUpTo(at);
    if (over === null) rows.push({ cells, given: null });
    else if (isSameRow(over, given[next] ?? null)) rows.push({ cells, given: given[next++]! });
  }
  takeUpTo(Infinity);
  return rows;
}

/// Of each row of a table the number that it has in the project, from 0; and the other way round.
export function placesInProject(rows: readonly Row[]): (number | null)[] {
  let next = 0;
  return rows.map(({ given }) => (given === null ? null : next++));
}
export function placeInTable(waiting: readonly Waiting[], number: number): number {
  return waiting.reduce((at, { at: own, over }) => (over === null && own <= at ? at + 1 : at), number);
}

/// The value of a row that the project has.
export const asGiven = (cells: Cells): TomlValue[] =>
  cells.slice(0, cells.findLastIndex((cell) => cell.trim() !== '') + 1).map((cell) => typedValue(cell) ?? '');

/// What the project takes of a table's rows, and what waits.
export function settled(rows: readonly Row[], least: number): { rows: TomlValue[][]; waiting: Waiting[] } {
  const taken: TomlValue[][] = [];
  const waiting: Waiting[] = [];
  rows.forEach(({ cells, given }, at) => {
    const value = rowValue(cells, least) ?? (given && asGiven(given));
    if (value) taken.push(value);
    if (!rowValue(cells, least) && !isSameRow(cells, given)) waiting.push({ at, cells, over: given });
  });
  return { rows: taken, waiting };
}

/// "row 4", "rows 3, 7 and 12", counted from 1.
export function rowsText(waiting: readonly Waiting[]): string {
  const numbers = waiting.map(({ at }) => at + 1);
  const last = numbers.pop();
  return numbers.length === 0 ? `row ${last}` : `rows ${numbers.join(', ')} and ${last}`;
}

/// What becomes of rows that are not complete, in sentences; those in which nothing is typed are not worth one.
export function sentencesOf(waiting: readonly Waiting[]): string[] {
  const typed = waiting.filter(({ cells }) => !isBlank(cells));
  const tell = (which: Waiting[], ending: string) => {
    if (which.length === 0) return [];
    const words = rowsText(which);
    return [`R${words.slice(1)} ${which.length === 1 ? 'is' : 'are'} not complete${ending}`];
  };
  const them = (which: Waiting[]) => (which.length === 1 ? 'it' : 'them');
  const [fresh, changing] = [typed.filter(({ over }) => !over), typed.filter(({ over }) => over)];
  return [
    ...tell(fresh, `: the project does not have ${them(fresh)} yet.`),
    ...tell(changing, `: the project keeps ${them(changing)} as before.`),
  ];
}
