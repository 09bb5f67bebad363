// The values of a TOML text.

import { getStaticTOMLValue, parseTOML, traverseNodes, type AST } from 'toml-eslint-parser';
import type { TomlTable } from './format';

/// Whole numbers of which a double would change digits are kept as they are written.
function keepDigits(node: AST.TOMLNode) {
  if (node.type !== 'TOMLValue' || node.kind !== 'integer' || Number.isSafeInteger(node.value)) return;
  (node as { value: number | bigint }).value = node.bigint;
}

/// Some editors begin a file with this mark, which says nothing of UTF-8.
export const withoutMark = (text: string) => text.replace(/^\ufeff/, '');

/// Throws where it is not TOML (ParseError, with `lineNumber`).
export function valuesOf(text: string): TomlTable {
  const program = parseTOML(withoutMark(text), { tomlVersion: '1.0' });
  traverseNodes(program, { enterNode: keepDigits, leaveNode: () => undefined });
  return getStaticTOMLValue(program) as TomlTable;
}
