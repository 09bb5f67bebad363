// The values of a TOML text.

import { getStaticTOMLValue, parseTOML, traverseNodes, type AST } from 'toml-eslint-parser';
import type { TomlTable } from './format';

/// Keeps integers beyond double precision as bigint.
function keepDigits(node: AST.TOMLNode) {
  if (node.type !== 'TOMLValue' || node.kind !== 'integer' || Number.isSafeInteger(node.value)) return;
  (node as { value: number | bigint }).value = node.bigint;
}

/// Drops a byte order mark, which some editors write.
export const withoutMark = (text: string) => text.replace(/^\ufeff/, '');

/// Throws ParseError, with `lineNumber`, if the text is not valid TOML.
export function valuesOf(text: string): TomlTable {
  const program = parseTOML(withoutMark(text), { tomlVersion: '1.0' });
  traverseNodes(program, { enterNode: keepDigits, leaveNode: () => undefined });
  return getStaticTOMLValue(program) as TomlTable;
}
