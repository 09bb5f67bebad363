// Adapts the engine's messages to the forms: rows and columns as in their tables, values as typed.

import type { Problem } from '../api/types';
import { isNumeral, numberOf } from '../settings/numbers';
import type { Kind } from '../settings/schema';

const words: Partial<Record<Kind['kind'], string[]>> = {
  tuple: ['column'],
  rows: ['row', 'column'],
  line: ['row', 'column'],
  'lists of rows': ['polyline', 'row', 'column'],
};

export interface Counting {
  kind?: Kind['kind'];
  columns: readonly string[];
  /// The index in the table of a row of the project.
  rowAt: (row: number) => number;
}

/// The engine's "section[3][0]" is "section, row 4, x" in the table.
function placeText(key: string, indices: number[], { kind, columns, rowAt }: Counting): string {
  const parts = indices.map((k, depth) => {
    const word = kind && words[kind]?.[depth];
    if (word === 'column') return columns[k] ?? `column ${k + 1}`;
    return word === 'row' ? `row ${rowAt(k) + 1}` : `${word ?? 'entry'} ${k + 1}`;
  });
  return [key, ...parts].join(', ');
}

/// A typed number that cannot be represented is a text in the file; it is reported as a number.
function asTyped({ what, why, hint }: Problem): { what: string; why: string; hint: string } {
  const text = / is "([^"]*)"$/.exec(what)?.[1];
  // Typed values have no quotes; only the file has them.
  if (text === undefined || !isNumeral(text) || numberOf(text) !== undefined)
    return { what, why, hint: hint.replace(/^(Write .*), without quotes$/, '$1') };
  const reason = 'it is too large or too small to be represented';
  return { what: what.replace(`"${text}"`, text), why: why ? `${reason}; ${why}` : reason, hint: '' };
}

/// The sentence of a problem without file, line and table.
export function sentence(problem: Problem, counting: Counting): string {
  const { what, why, hint } = asTyped(problem);
  const counted = what.replace(/^(\w+)((?:\[\d+\])+)/, (_all, key: string, brackets: string) =>
    placeText(key, [...brackets.matchAll(/\d+/g)].map(Number), counting),
  );
  return `${counted}${why ? ` (${why})` : ''}${hint ? `. ${hint}` : ''}`;
}
