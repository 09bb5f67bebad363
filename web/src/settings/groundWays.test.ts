import { expect, test } from 'vitest';
import { changeWay, groundWays, materialsWith, wayOf, waysFor } from './groundWays';

test('the way is found by the given settings', () => {
  expect(wayOf({}).name).toBe('one');
  expect(wayOf({ default: 'A', classes: {}, raster: 'x.tif' }).name).toBe('raster');
});

test('changing the way removes the settings of the old one', () =>
  expect(changeWay(groundWays[0]!, { polygons: 'a.gpkg', attribute: 'm', default: 'A' }, ['A', 'B'])).toEqual([
    { remove: ['ground', 'polygons'] },
    { remove: ['ground', 'attribute'] },
  ]));

test('with several materials a default is assigned', () =>
  expect(changeWay(groundWays[2]!, {}, ['A', 'B'])).toEqual([{ set: ['ground', 'default'], value: 'A' }]));

test('a missing or short list is filled up with the default material', () => {
  expect(materialsWith(undefined, 3, 1, 'B', 'A')).toEqual(['A', 'B', 'A']);
  expect(materialsWith(['B'], 2, 1, 'C', 'A')).toEqual(['B', 'C']);
  expect(materialsWith([1, 1], 3, 0, 0, 0)).toEqual([0, 1, 0]);
});

test('a section has segments, a raster has none', () => {
  expect(waysFor('section').map(({ name }) => name)).toEqual(['one', 'segments']);
  expect(waysFor('raster').map(({ name }) => name)).toEqual(['one', 'polygons', 'raster']);
  expect(waysFor('polylines').map(({ name }) => name)).toContain('triangles');
});
