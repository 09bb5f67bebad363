// Inserting and removing parts of a text: lines with their comments, entries of lists.

import type { AST } from 'toml-eslint-parser';

export const splice = (text: string, from: number, to: number, piece: string) =>
  text.slice(0, from) + piece + text.slice(to);

export const lineEnd = (text: string, at: number) => {
  const end = text.indexOf('\n', at);
  return end < 0 ? text.length : end;
};

export const lineStart = (text: string, at: number) => text.lastIndexOf('\n', at - 1) + 1;

/// Inserts lines after the line of a position.
export function insertAfter(text: string, at: number, lines: string): string {
  const end = lineEnd(text, at);
  return end === text.length ? `${text}\n${lines}\n` : splice(text, end + 1, end + 1, `${lines}\n`);
}

/// The start of the comment lines directly above a line.
export function commentStart(text: string, line: number): number {
  let start = line;
  while (start > 0) {
    const above = lineStart(text, start - 1);
    if (!text.slice(above, start).trimStart().startsWith('#')) break;
    start = above;
  }
  return start;
}

/// Whether a range is alone on its lines, except for a comma and a comment after it.
function isAlone(text: string, [from, to]: AST.Range): boolean {
  const before = text.slice(lineStart(text, from), from);
  return before.trim() === '' && /^[ \t]*,?[ \t]*(#.*)?$/.test(text.slice(to, lineEnd(text, to)));
}

/// Inserts an entry after the last one of a list that ends at `end`, on its own line if the last one is.
export function insertListed(text: string, last: AST.Range, end: number, piece: string): string {
  if (!isAlone(text, last) || lineEnd(text, last[1]) >= end) return splice(text, last[1], last[1], `, ${piece}`);
  const start = lineStart(text, last[0]);
  const indent = text.slice(start, last[0]);
  const hasComma = /^\s*,/.test(text.slice(last[1], end));
  const at = lineEnd(text, last[1]);
  const grown = splice(text, at, at, `\n${indent}${piece}${hasComma ? ',' : ''}`);
  return hasComma ? grown : splice(grown, last[1], last[1], ',');
}

/// Inserts an entry before another one of a list, on its own line and above the comment of the other one if that has its
/// own line.
export function insertBefore(text: string, [from, to]: AST.Range, piece: string): string {
  if (!isAlone(text, [from, to])) return splice(text, from, from, `${piece}, `);
  const start = lineStart(text, from);
  const at = commentStart(text, start);
  return splice(text, at, at, `${text.slice(start, from)}${piece},\n`);
}

/// Removes one of several comma-separated entries.
export function removeListed(text: string, list: readonly { range: AST.Range }[], k: number): string {
  const [from, to] = list[k]!.range;
  if (list.length > 1 && isAlone(text, [from, to]))
    return splice(text, lineStart(text, from), lineEnd(text, to) + 1, '');
  const next = list[k + 1];
  if (next) return splice(text, from, next.range[0], '');
  const before = list[k - 1];
  if (before) return splice(text, before.range[1], to, '');
  const comma = /^\s*,/.exec(text.slice(to));
  return splice(text, from, to + (comma ? comma[0].length : 0), '');
}
