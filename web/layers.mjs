// The layers of src, from low to high, and the check that no import points upward: a folder imports from lower layers,
// and from folders before it in its own layer. Some libraries are known to few folders. `node layers.mjs` names every
// import that breaks this.

import { readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

export const layers = [
  { name: 'values', folders: ['generated', 'archive', 'geometry', 'toml', 'units', 'settings'] },
  { name: 'figures', folders: ['figures'] },
  { name: 'report', folders: ['report'] },
  { name: 'server', folders: ['api'] },
  { name: 'state', folders: ['state', 'project', 'runs'] },
  { name: 'controls', folders: ['ui', 'charts'] },
  { name: 'drawing', folders: ['view', 'tools', 'drag', 'layers', 'maps', 'paths', 'animation'] },
  {
    name: 'panels',
    folders: ['help', 'runList', 'results', 'sectionLine', 'askLine', 'answers', 'calibration', 'slopeTools', 'dropped', 'forms', 'start'],
  },
  { name: 'views', folders: ['scene', 'section'] },
  { name: 'page', folders: ['page'] },
];

const foldersFrom = (/** @type {string} */ lowest) =>
  layers.slice(layers.findIndex(({ name }) => name === lowest)).flatMap(({ folders }) => folders);

/// The folders that know a library, by the beginning of its name.
/** @type {Record<string, readonly string[]>} */
export const libraries = { preact: foldersFrom('controls'), 'd3-': ['figures'], three: ['scene'] };

/// An import by a file of src, such as "view/sheet", of another file there or of a library.
/// @typedef {{ from: string, to: string } | { from: string, library: string }} Import

const folderOf = (/** @type {string} */ file) => file.slice(0, file.indexOf('/'));

/// What is wrong with imports and with the list of folders that exist, one sentence each.
/// @param {readonly Import[]} imports
/// @param {readonly string[]} folders
export function objections(imports, folders, rules = layers) {
  const order = rules.flatMap(({ name, folders: own }) => own.map((folder) => ({ folder, layer: name })));
  const placeOf = (/** @type {string} */ folder) => order.findIndex((each) => each.folder === folder);
  const found = [
    ...folders.filter((folder) => placeOf(folder) < 0).map((folder) => `${folder} is in no layer (web/layers.mjs)`),
    ...order
      .filter(({ folder }) => !folders.includes(folder))
      .map(({ folder }) => `the layer of ${folder} is declared, but there is no such folder`),
  ];
  for (const { from, ...what } of imports) {
    const own = folderOf(from);
    if ('library' in what) {
      const [, few] = Object.entries(libraries).find(([name]) => what.library.startsWith(name)) ?? [];
      if (few && !few.includes(own))
        found.push(`${from} imports ${what.library}, which only ${few.join(', ')} may know`);
      continue;
    }
    const [lower, higher] = [order[placeOf(own)], order[placeOf(folderOf(what.to))]];
    if (!lower || !higher || order.indexOf(higher) <= order.indexOf(lower)) continue;
    const isBeside = lower.layer === higher.layer;
    const why = isBeside ? `${own} is before ${higher.folder} in the list` : `${lower.layer} may not know ${higher.layer}`;
    found.push(`${from} imports ${what.to}: ${why}`);
  }
  return found;
}

/// The imports of a file of src.
/// @returns {Import[]}
export function importsOf(/** @type {string} */ file, /** @type {string} */ text) {
  const from = file.replace(/\.tsx?$/, '');
  const named = ts.preProcessFile(text).importedFiles.map(({ fileName }) => fileName);
  return named.map((name) =>
    name.startsWith('.') ? { from, to: posix.join(posix.dirname(file), name) } : { from, library: name },
  );
}

/// The files of src and their texts.
export function sources() {
  const source = fileURLToPath(new URL('./src/', import.meta.url));
  const files = readdirSync(source, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
  return files.map((file) => ({ file, text: readFileSync(join(source, file), 'utf8') }));
}

/// All that is wrong in src.
export function objectionsToSource() {
  const files = sources();
  const folders = [...new Set(files.filter(({ file }) => file.includes('/')).map(({ file }) => folderOf(file)))];
  // main.tsx, which starts the page, is above all folders.
  const imports = files.filter(({ file }) => file !== 'main.tsx').flatMap(({ file, text }) => importsOf(file, text));
  return { count: imports.length, found: objections(imports, folders) };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { found } = objectionsToSource();
  for (const sentence of found) console.error(sentence);
  process.exitCode = found.length > 0 ? 1 : 0;
}
