// Edits a TOML text locally: comments, order and layout of everything else are preserved.

import { parseTOML, type AST } from 'toml-eslint-parser';
import { commentStart, insertAfter, insertBefore, insertListed, lineEnd, lineStart, removeListed, splice } from './lines';
import { inlineText, keyText, pairText, tableText, type TomlTable, type TomlValue } from './format';
import { withoutMark } from './values';

export type Path = readonly (string | number)[];

export type Edit =
  /// Replaces or adds the value at a path. Missing tables are created.
  | { set: Path; value: TomlValue }
  /// Removes a key, an entry of a list, or a table with its subtables, if it exists.
  | { remove: Path }
  /// Inserts an entry into a list, before the one at the path or at its end.
  | { insert: Path; value: TomlValue }
  /// Adds a table `[[path]]` after the last of its kind, below a comment if one is given.
  | { append: Path; value: TomlTable; comment?: string };

export function edited(text: string, edits: readonly Edit[]): string {
  const own = withoutMark(text);
  if (own !== text) return text[0] + edited(own, edits);
  // Windows line ends are kept if the text has no others.
  if (/\r\n/.test(text) && !/(^|[^\r])\n/.test(text))
    return edited(text.replaceAll('\r\n', '\n'), edits).replaceAll('\n', '\r\n');
  return edits.reduce((now, edit) => {
    if ('set' in edit) return setValue(now, edit.set, edit.value);
    if ('remove' in edit) return removeAt(now, edit.remove);
    if ('insert' in edit) return insertAt(now, edit.insert, edit.value);
    return appendTable(now, edit.append, edit.value, edit.comment);
  }, text);
}

type Table = AST.TOMLTopLevelTable | AST.TOMLTable;
type Pair = AST.TOMLKeyValue;
type Content = AST.TOMLContentNode;

const isPrefix = (prefix: Path, path: Path) =>
  prefix.length <= path.length && prefix.every((part, k) => String(part) === String(path[k]));
const isSame = (a: Path, b: Path) => a.length === b.length && isPrefix(a, b);

function topOf(text: string): AST.TOMLTopLevelTable {
  return parseTOML(text, { tomlVersion: '1.0' }).body[0];
}

/// The keys before the first table, then each table with its header.
function tablesOf(top: AST.TOMLTopLevelTable): { path: Path; node: Table; pairs: Pair[] }[] {
  const pairs = top.body.filter((node): node is Pair => node.type === 'TOMLKeyValue');
  const tables = top.body.filter((node): node is AST.TOMLTable => node.type === 'TOMLTable');
  return [
    { path: [], node: top, pairs },
    ...tables.map((node) => ({ path: node.resolvedKey, node, pairs: node.body })),
  ];
}

const keysOf = (pair: Pair) => pair.key.keys.map((key) => (key.type === 'TOMLBare' ? key.name : key.value));

/// The pair at or above a path, and the rest of the path into its value.
function findPair(top: AST.TOMLTopLevelTable, path: Path): { pair: Pair; rest: Path } | null {
  for (const table of tablesOf(top)) {
    if (!isPrefix(table.path, path)) continue;
    for (const pair of table.pairs) {
      const whole = [...table.path, ...keysOf(pair)];
      if (whole.length > table.path.length && isPrefix(whole, path)) return { pair, rest: path.slice(whole.length) };
    }
  }
  return null;
}

function childOf(node: Content, part: string | number): Content | null {
  if (node.type === 'TOMLArray') return node.elements[Number(part)] ?? null;
  if (node.type === 'TOMLInlineTable') return memberOf(node, part)?.value ?? null;
  return null;
}

function memberOf(node: AST.TOMLInlineTable, part: string | number): Pair | null {
  return node.body.find((pair) => isSame(keysOf(pair), [part])) ?? null;
}

/// Nested tables along the path around a value.
function wrapped(path: Path, value: TomlValue): TomlValue {
  return path.reduceRight<TomlValue>((inner, part) => ({ [String(part)]: inner }), value);
}

function setInside(text: string, node: Content, path: Path, value: TomlValue): string {
  if (path.length === 0) return splice(text, node.range[0], node.range[1], inlineText(value));
  const [part, ...rest] = path as [string | number, ...(string | number)[]];
  const child = childOf(node, part);
  if (child) return setInside(text, child, rest, value);
  const fresh = wrapped(rest, value);
  if (node.type === 'TOMLInlineTable') {
    const last = node.body.at(-1);
    const piece = pairText(String(part), fresh);
    return last
      ? splice(text, last.range[1], last.range[1], `, ${piece}`)
      : splice(text, node.range[0], node.range[1], `{ ${piece} }`);
  }
  if (node.type === 'TOMLArray' && Number(part) === node.elements.length) {
    const last = node.elements.at(-1);
    return last
      ? insertListed(text, last.range, node.range[1], inlineText(fresh))
      : splice(text, node.range[0], node.range[1], `[${inlineText(fresh)}]`);
  }
  // A plain value is replaced by a table: 0.35 becomes { mean = 0.4 } when its mean is set.
  return splice(text, node.range[0], node.range[1], inlineText(wrapped(path, value)));
}

/// The last dotted pair that shares the beginning of the path, and the table above it.
function dottedSibling(top: AST.TOMLTopLevelTable, path: Path): { pair: Pair; above: Path } | null {
  let found: { pair: Pair; above: Path } | null = null;
  for (const table of tablesOf(top)) {
    if (!isPrefix(table.path, path)) continue;
    for (const pair of table.pairs) {
      const next = table.path.length;
      if (keysOf(pair).length > 1 && path.length > next + 1 && String(path[next]) === keysOf(pair)[0])
        found = { pair, above: table.path };
    }
  }
  return found;
}

/// Whether the value at a path is spread over tables or dotted keys.
const isScattered = (top: AST.TOMLTopLevelTable, path: Path) =>
  tablesOf(top).some(
    (table) =>
      (table.path.length >= path.length && isPrefix(path, table.path)) ||
      table.pairs.some((pair) => {
        const whole = [...table.path, ...keysOf(pair)];
        return whole.length > path.length && isPrefix(path, whole);
      }),
  );

function setValue(text: string, path: Path, value: TomlValue): string {
  if (path.length === 0) throw new Error('a path is needed');
  const top = topOf(text);
  const found = findPair(top, path);
  if (found) return setInside(text, found.pair.value, found.rest, value);

  if (isScattered(top, path)) return setValue(removeAt(text, path), path, value);
  const sibling = dottedSibling(top, path);
  if (sibling) {
    const keys = path.slice(sibling.above.length).map((part) => keyText(String(part)));
    return insertAfter(text, sibling.pair.range[1], `${keys.join('.')} = ${inlineText(value)}`);
  }

  // The innermost table above the path that has a header, or the keys before the first table.
  const tables = tablesOf(top).filter(({ path: above }) => isPrefix(above, path) && above.length < path.length);
  const home = tables.reduce((best, table) => (table.path.length >= best.path.length ? table : best));
  const rest = path.slice(home.path.length);
  if (home.path.length === 0 && rest.length > 1) {
    const header = rest.slice(0, -1);
    if (typeof header[1] === 'number') throw new Error(`there is no [[${String(header[0])}]] number ${header[1]}`);
    // A new top-level table has a header; tables within it are inline.
    const [name, ...inner] = rest;
    const piece = `[${keyText(String(name))}]\n${pairText(String(inner[0]), wrapped(inner.slice(1), value))}`;
    return `${text.trimEnd()}${text.trim() ? '\n\n' : ''}${piece}\n`;
  }
  const piece = pairText(String(rest[0]), wrapped(rest.slice(1), value));
  const last = home.pairs.at(-1);
  if (last) return insertAfter(text, last.range[1], piece);
  if (home.node.type === 'TOMLTable') return insertAfter(text, home.node.key.range[1], piece);
  return beforeFirstTable(text, top, piece);
}

/// Inserts text before the first table and its comment.
function beforeFirstTable(text: string, top: AST.TOMLTopLevelTable, piece: string): string {
  const first = top.body[0];
  if (!first) return `${text.trimEnd()}${text.trim() ? '\n' : ''}${piece}\n`;
  const start = commentStart(text, lineStart(text, first.range[0]));
  return splice(text, start, start, `${piece}\n\n`);
}

function removeInside(text: string, node: Content, path: Path): string {
  const [part, ...rest] = path as [string | number, ...(string | number)[]];
  if (rest.length > 0) {
    const child = childOf(node, part);
    return child ? removeInside(text, child, rest) : text;
  }
  if (node.type === 'TOMLArray') {
    return Number(part) < node.elements.length ? removeListed(text, node.elements, Number(part)) : text;
  }
  if (node.type !== 'TOMLInlineTable') return text;
  const k = node.body.findIndex((pair) => isSame(keysOf(pair), [part]));
  return k < 0 ? text : removeListed(text, node.body, k);
}

function removeAt(text: string, path: Path): string {
  const top = topOf(text);
  const found = findPair(top, path);
  if (found) {
    if (found.rest.length > 0) return removeInside(text, found.pair.value, found.rest);
    const end = Math.min(lineEnd(text, found.pair.range[1]) + 1, text.length);
    return splice(text, lineStart(text, found.pair.range[0]), end, '');
  }
  // Dotted keys with their lines, and tables with their comments, from the last one on, so that positions stay valid.
  const whole = (table: Path, pair: Pair) => [...table, ...keysOf(pair)];
  const dotted = tablesOf(top).flatMap(({ path: own, pairs }) =>
    isPrefix(path, own) ? [] : pairs.filter((pair) => isPrefix(path, whole(own, pair))),
  );
  const tables = tablesOf(top).slice(1);
  const startOf = (k: number) => {
    const table = tables[k];
    return table ? commentStart(text, lineStart(text, table.node.range[0])) : text.length;
  };
  const ranges: [number, number][] = [
    ...dotted.map(({ range: [from, to] }): [number, number] => [lineStart(text, from), lineEnd(text, to) + 1]),
    ...tables.flatMap(({ path: own }, k): [number, number][] =>
      isPrefix(path, own) ? [[startOf(k), startOf(k + 1)]] : [],
    ),
  ];
  if (ranges.length === 0) return text;
  const left = ranges.sort(([a], [b]) => b - a).reduce((now, [from, to]) => splice(now, from, to, ''), text);
  const isAtEnd = ranges.some(([, to]) => to >= text.length);
  return isAtEnd && left.trim() ? `${left.trimEnd()}\n` : left;
}

function insertAt(text: string, path: Path, value: TomlValue): string {
  const list = path.slice(0, -1);
  const found = findPair(topOf(text), list);
  const node = found && found.rest.reduce<Content | null>((at, part) => at && childOf(at, part), found.pair.value);
  if (node?.type !== 'TOMLArray') throw new Error(`${list.join('.')} is not a list`);
  const next = node.elements[Number(path.at(-1))];
  return next ? insertBefore(text, next.range, inlineText(value)) : setValue(text, [...list, node.elements.length], value);
}

function appendTable(text: string, path: Path, value: TomlTable, comment?: string): string {
  const top = topOf(text);
  const found = findPair(top, path);
  if (found && found.rest.length === 0 && found.pair.value.type === 'TOMLArray')
    return setInside(text, found.pair.value, [found.pair.value.elements.length], value);
  if (found || tablesOf(top).some(({ path: own }) => isSame(own, path)))
    throw new Error(`${path.join('.')} already exists and is not a list of tables`);
  const piece = `${comment === undefined ? '' : `# ${comment}\n`}${tableText(path.map(String), value)}`;
  const last = tablesOf(top).findLast(({ path: own }) => own.length > path.length && isPrefix(path, own));
  if (!last) return `${text.trimEnd()}${text.trim() ? '\n\n' : ''}${piece}\n`;
  const end = Math.max(last.node.range[1], last.pairs.at(-1)?.range[1] ?? 0);
  return insertAfter(text, end, `\n${piece}`);
}
