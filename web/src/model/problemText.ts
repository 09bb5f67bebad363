// The engine's words for what is wrong, as the forms count and type.

import type { Problem } from '../api/types';
import { isNumeral, numberOf } from './numbers';
import type { Kind } from './schema';

const words: Partial<Record<Kind['kind'], string[]>> = {
  tuple: ['column'],
  rows: ['row', 'column'],
  line: ['row', 'column'],
  'lists of rows': ['polyline', 'row', 'column'],
};

export interface Counting {
  kind?: Kind['kind'];
  columns: readonly string[];
  /// The place in its table of a row of the project.
  rowAt: (row: number) => number;
}

/// "section[3][0]" of the engine is "section, row 4, x" of the table.
function placeText(key: string, indices: number[], { kind, columns, rowAt }: Counting): string {
  const parts = indices.map((k, depth) => {
    const word = kind && words[kind]?.[depth];
    if (word === 'column') return columns[k] ?? `column ${k + 1}`;
    return word === 'row' ? `row ${rowAt(k) + 1}` : `${word ?? 'entry'} ${k + 1}`;
  });
  return [key, ...parts].join(', ');
}

/// A number that was typed and cannot be kept stands in the file as a text.
function told({ what, why, hint }: Problem): { what: string; why: string; hint: string } {
  const text = / is "([^"]*)"$/.exec(what)?.[1];
  // Who types into a field writes no quotes; only the file has them.
  if (text === undefined || !isNumeral(text) || numberOf(text) !== undefined)
    return { what, why, hint: hint.replace(/^(Write .*), without quotes$/, '$1') };
  const reason = 'it is too large, or too small, to be kept';
  return { what: what.replace(`"${text}"`, text), why: why ? `${reason}; ${why}` : reason, hint: '' };
}

/// A sentence without the file's line and table.
export function sentence(problem: Problem, counting: Counting): string {
  const { what, why, hint } = told(problem);
  const counted = what.replace(/^(\w+)((?:\[\d+\])+)/, (_all, key: string, brackets: string) =>
    placeText(key, [...brackets.matchAll(/\d+/g)].map(Number), counting),
  );
  return `${counted}${why ? ` (${why})` : ''}${hint ? `. ${hint}` : ''}`;
}
