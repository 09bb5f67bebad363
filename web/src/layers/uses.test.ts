import { expect, test } from 'vitest';
import { barrierEdits, choicesFor, freeName, layerEdits, releaseEdits, type ReadShape } from './uses';

const line: ReadShape = { kind: 'line', points: [[1.2345, 2], [3, 4.999]] };
const area: ReadShape = { kind: 'polygon', points: [[0, 0], [1, 0], [1, 1]] };
const uses = (...args: Parameters<typeof choicesFor>) => choicesFor(...args).map(({ use }) => use);

test('a file can be what its shapes allow', () => {
  expect(uses('picture', null)).toEqual(['layer', 'store']);
  expect(uses('raster', null)).toEqual(['layer', 'terrain', 'store']);
  expect(uses('vector', [line])).toEqual(['layer', 'barrier', 'collector', 'release', 'ask', 'terrain', 'store']);
  expect(uses('vector', [area])).toEqual(['layer', 'release', 'ground', 'ask', 'store']);
  expect(uses('vector', null)).toEqual(['layer', 'store']);
  expect(uses('vector', Array.from({ length: 51 }, () => line))).not.toContain('barrier');
});

test('every line becomes a barrier with a name of its own, to the centimetre', () => {
  expect(barrierEdits('barrier', 'gis/nets.gpkg', [line, area, line], ['Nets'])).toEqual([
    { append: ['barrier'], value: { name: 'nets 2', line: [[1.23, 2], [3, 5]], height_m: 3 } },
    { append: ['barrier'], value: { name: 'nets 3', line: [[1.23, 2], [3, 5]], height_m: 3 } },
  ]);
});

test('releases and layers name the file', () => {
  expect(releaseEdits('cliff.shp', [area, line], [])).toEqual([{ append: ['seeder'], value: { name: 'cliff', type: 'polygon', polygons: 'cliff.shp', rocks: 1000 } }]);
  expect(releaseEdits('cliff.shp', [line], [])).toEqual([{ append: ['seeder'], value: { name: 'cliff', type: 'line', lines: 'cliff.shp', rocks: 1000 } }]);
  expect(layerEdits('ortho.tif', ['ortho'])).toEqual([{ append: ['layer'], value: { name: 'ortho 2', file: 'ortho.tif' } }]);
  expect(freeName('a', ['b'])).toBe('a');
});
