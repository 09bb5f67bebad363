// The check that a piece of state has one owner: a signal is set only in the module that has it. `node owners.mjs` names
// every module that sets an imported one.

import { fileURLToPath } from 'node:url';
import ts from 'typescript';
import { sources } from './layers.mjs';

/// The names that a file imports, `* as` names among them.
function importedBy(/** @type {ts.SourceFile} */ file) {
  /** @type {Set<string>} */
  const names = new Set();
  for (const statement of file.statements) {
    if (!ts.isImportDeclaration(statement)) continue;
    const bindings = statement.importClause?.namedBindings;
    if (bindings && ts.isNamespaceImport(bindings)) names.add(bindings.name.text);
    else for (const { name } of bindings?.elements ?? []) names.add(name.text);
  }
  return names;
}

const isAssignment = (/** @type {ts.Node} */ node) =>
  ts.isBinaryExpression(node) &&
  node.operatorToken.kind >= ts.SyntaxKind.FirstAssignment &&
  node.operatorToken.kind <= ts.SyntaxKind.LastAssignment;

const isStep = (/** @type {ts.Node} */ node) =>
  (ts.isPrefixUnaryExpression(node) || ts.isPostfixUnaryExpression(node)) &&
  [ts.SyntaxKind.PlusPlusToken, ts.SyntaxKind.MinusMinusToken].includes(node.operator);

/// The first name of "picture.pointer.value".
function rootOf(/** @type {ts.Expression} */ expression) {
  let at = expression;
  while (ts.isPropertyAccessExpression(at)) at = at.expression;
  return ts.isIdentifier(at) ? at.text : undefined;
}

/// The imported signals that a text sets, with their lines.
export function setByOthers(/** @type {string} */ name, /** @type {string} */ text) {
  const kind = name.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS;
  const file = ts.createSourceFile(name, text, ts.ScriptTarget.Latest, false, kind);
  const imported = importedBy(file);
  /** @type {string[]} */
  const found = [];
  const target = (/** @type {ts.Node} */ node) => {
    if (ts.isPropertyAccessExpression(node) && node.name.text === 'value' && imported.has(rootOf(node) ?? '')) {
      const { line } = file.getLineAndCharacterOfPosition(node.getStart(file));
      found.push(`${name}:${line + 1} sets ${node.getText(file)}, which another module has`);
    } else if (ts.isArrayLiteralExpression(node)) node.elements.forEach(target);
  };
  const walk = (/** @type {ts.Node} */ node) => {
    if (isAssignment(node)) target(node.left);
    else if (isStep(node)) target(node.operand);
    ts.forEachChild(node, walk);
  };
  walk(file);
  return found;
}

export const foundInSource = () =>
  sources()
    .filter(({ file }) => !file.endsWith('.test.ts'))
    .flatMap(({ file, text }) => setByOthers(file, text));

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const found = foundInSource();
  for (const sentence of found) console.error(sentence);
  process.exitCode = found.length > 0 ? 1 : 0;
}
