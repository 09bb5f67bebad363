import { expect, test } from 'vitest';
import { importsOf, layers, objections, objectionsToSource } from './layers.mjs';

test('no folder of the page imports from a higher one', () => {
  const { count, found } = objectionsToSource();
  expect(found).toEqual([]);
  expect(count).toBeGreaterThan(1000);
});

const rules = [
  { name: 'low', folders: ['a', 'b'] },
  { name: 'high', folders: ['c', 'd', 'e'] },
];
const folders = ['a', 'b', 'c', 'd', 'e'];
const importing = (...pairs: string[]) =>
  objections(pairs.map((pair) => ({ from: `${pair[0]!}/x`, to: `${pair[1]!}/y` })), folders, rules);

test('imports within a folder, downward, and of folders before it in its layer are allowed', () => {
  expect(importing('aa', 'ca', 'db', 'ba', 'dc', 'ed', 'ec')).toEqual([]);
});

test('an upward import would be found', () => {
  expect(importing('ca', 'bd')).toEqual(['b/x imports d/y: low may not know high']);
});

test('an import of a folder after it in its layer would be found', () => {
  expect(importing('dc', 'cd')).toEqual(['c/x imports d/y: c is before d in the list']);
});

test('a library in a wrong folder would be found', () => {
  const all = layers.flatMap((layer) => layer.folders);
  const imports = [
    { from: 'project/x', library: '@preact/signals' },
    { from: 'forms/x', library: 'preact/hooks' },
    { from: 'scene/x', library: 'three' },
    { from: 'project/x', library: 'preact/hooks' },
    { from: 'section/x', library: 'three' },
  ];
  const found = objections(imports, all);
  expect(found).toHaveLength(2);
  expect(found[0]).toMatch(/^project\/x imports preact\/hooks, which only ui, charts, view, .*, page may know$/);
  expect(found[1]).toBe('section/x imports three, which only scene may know');
});

test('a folder without a layer, and a layer without its folder, would be found', () => {
  expect(objections([], ['a', 'b', 'c', 'd', 'f'], rules)).toEqual([
    'f is in no layer (web/layers.mjs)',
    'the layer of e is declared, but there is no such folder',
  ]);
});

test('imports are found in every form', () => {
  const text = `import { a } from './near';\nimport type { B } from '../api/types';\nimport '../ui/theme.css';\nexport { c } from '../units/units';
import { signal } from '@preact/signals';\n// import '../no/comment';\nconst d = import('../scene/open');\n`;
  const from = 'view/file';
  expect(importsOf('view/file.ts', text)).toEqual([
    ...['view/near', 'api/types', 'ui/theme.css', 'units/units'].map((to) => ({ from, to })),
    { from, library: '@preact/signals' },
    { from, to: 'scene/open' },
  ]);
});
