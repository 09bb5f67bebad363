// Converts rows of numbers between the project and an edit table.

import { isSame } from '../toml/differences';
import type { Edit, Path } from './names';
import type { TomlValue } from '../toml/format';
import { cellText, typedValue } from './numbers';

/// The cells of a table as text, filled up to `columns`. A row that is not a list has one cell.
export function cellsOf(value: unknown, columns: number): string[][] {
  if (!Array.isArray(value)) return [];
  return value.map((row: unknown) => {
    const cells = Array.isArray(row) ? row.map(cellText) : [cellText(row)];
    return cells.concat(Array<string>(Math.max(0, columns - cells.length)).fill(''));
  });
}

/// A row's value; undefined while one of the first `least` cells, or a cell before the last given one, is empty.
export function rowValue(cells: readonly string[], least: number): TomlValue[] | undefined {
  const filled = cells.findLastIndex((cell) => cell.trim() !== '') + 1;
  if (filled < least) return undefined;
  const values = cells.slice(0, filled).map(typedValue);
  return values.some((value) => value === undefined) ? undefined : (values as TomlValue[]);
}

/// Cells overwritten by a block from a cell on. Missing rows are added; columns beyond the table are dropped.
export function overlaid(
  cells: readonly (readonly string[])[],
  block: readonly string[][],
  row: number,
  column: number,
  columns: number,
): string[][] {
  const result = cells.map((line) => [...line]);
  block.forEach((line, k) => {
    while (result.length <= row + k) result.push(Array<string>(columns).fill(''));
    line.forEach((cell, j) => {
      if (column + j < columns) result[row + k]![column + j] = cell;
    });
  });
  return result;
}

/// The fewest edits from one list of rows to another, so that the layout of the rest is kept.
export function rowEdits(path: Path, before: unknown, after: TomlValue[]): Edit[] {
  const old = Array.isArray(before) ? (before as TomlValue[]) : undefined;
  if (!old || old.length === 0 || after.length === 0) return [{ set: path, value: after }];
  if (after.length >= old.length) {
    const edits = after.flatMap<Edit>((row, r) => {
      const known = old[r];
      if (isSame(known, row)) return [];
      const isChangedInside = Array.isArray(known) && Array.isArray(row) && known.length === row.length;
      if (!isChangedInside) return [{ set: [...path, r], value: row }];
      return row.flatMap((value, c) => (isSame(known[c], value) ? [] : [{ set: [...path, r, c], value }]));
    });
    // With many changes the whole list is written, one row per line.
    return edits.length <= 8 ? edits : [{ set: path, value: after }];
  }
  const first = after.findIndex((row, k) => !isSame(old[k], row));
  const gone = first < 0 ? after.length : first;
  const isOneGone =
    old.length === after.length + 1 && after.slice(gone).every((row, k) => isSame(old[gone + 1 + k], row));
  return isOneGone ? [{ remove: [...path, gone] }] : [{ set: path, value: after }];
}
