// Tables of the page and of the verification manual.

import type { Locator } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { sources } from './workbench';

/// The texts of a table's cells, row by row, without the head.
export async function cellsOf(table: Locator): Promise<string[][]> {
  return table.locator('tbody tr').evaluateAll((rows) =>
    rows.map((row) => [...row.querySelectorAll('th, td')].map((cell) => cell.textContent ?? '')),
  );
}

/// The rows of a CSV file without quotes, by column.
export function rowsOf(csv: string): Record<string, string>[] {
  const [head, ...lines] = csv.trim().split(/\r?\n/).map((line) => line.split(','));
  return lines.map((line) => Object.fromEntries(head!.map((name, k) => [name, line[k] ?? ''])));
}

/// A table of the verification manual.
export const published = (name: string) => rowsOf(readFileSync(join(sources, 'verification', name), 'utf8'));

/// One unit of the last printed digit.
export const printedUnit = (text: string) => 10 ** -(text.split('.')[1]?.length ?? 0);
