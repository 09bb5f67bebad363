import { expect, test } from 'vitest';
import { barrierEdits, choicesFor, freeName, layerEdits, refusals, releaseEdits, terrainChoices, type Outcome, type ReadShape } from './uses';

const line: ReadShape = { kind: 'line', points: [[1.2345, 2], [3, 4.999]] };
const area: ReadShape = { kind: 'polygon', points: [[0, 0], [1, 0], [1, 1]] };
const uses = (...args: Parameters<typeof choicesFor>) => choicesFor(...args).map(({ use }) => use);

test('a file can be what its shapes allow', () => {
  expect(uses('picture', null)).toEqual(['layer', 'store']);
  expect(uses('raster', null)).toEqual(['layer', 'terrain', 'store']);
  expect(uses('raster', null, { isInSpace: false })).toEqual(['terrain', 'store']);
  expect(uses('points', null)).toEqual(['terrain', 'store']); // a point cloud
  expect(uses('mesh', null)).toEqual(['terrain', 'store']);
  expect(uses('vector', [line])).toEqual(['layer', 'barrier', 'collector', 'release', 'ask', 'terrain', 'store']);
  expect(uses('vector', [area])).toEqual(['layer', 'release', 'ground', 'forest', 'ask', 'store']);
  expect(uses('vector', null)).toEqual(['layer', 'store']);
  expect(uses('vector', Array.from({ length: 51 }, () => line))).not.toContain('barrier');
});

/// Of vertices on x from 0 to `length`, within `width` of y = 0.
const built = (length: number, width = 0, facets = 3): Outcome => ({ terrain: { facets, bounds: { min: [0, 0, 0], max: [length, width, 9] } } });
const refused = (...texts: string[]): Outcome => ({
  problems: texts.map((text) => ({ severity: 'error', path: 'terrain', file: '', line: 0, where: '', what: '', why: '', hint: '', text })),
});

test('a table is a section if its points follow a line, and a survey if they wander', () => {
  const asked = (section: Outcome, survey: Outcome) => terrainChoices('points', { section, survey }).map(({ use }) => use);
  expect(asked(built(100), built(80, 40))).toEqual(['section', 'terrain', 'store']);
  expect(asked(built(1000), built(100, 100))).toEqual(['terrain', 'section', 'store']);
  expect(asked(built(100, 0, 100_001), built(100))).toEqual(['terrain', 'section', 'store']);
  expect(asked(built(100), refused('has no y'))).toEqual(['section', 'store']);
  expect(asked(refused('two lines'), built(9, 9))).toEqual(['terrain', 'store']);
  expect(uses('vector', [line], { isSection: true })).toContain('section');
});

test('a file that is no section says why', () => {
  const texts = (section: Outcome, survey: Outcome) => refusals({ section, survey }).map(({ text }) => text);
  expect(texts(built(1), refused('has no y'))).toEqual([]);
  expect(texts(refused('two lines'), built(1, 1))).toEqual(['As a section: two lines']);
  expect(texts(refused('in feet'), refused('in feet', 'empty'))).toEqual(['in feet', 'As a survey: empty']);
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
