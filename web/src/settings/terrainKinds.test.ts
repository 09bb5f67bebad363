import { expect, test } from 'vitest';
import { changeTo, terrainKinds } from './terrainKinds';

const kind = (name: string) => terrainKinds.find((one) => one.name === name)!;

test('choosing the same kind again changes nothing', () => {
  expect(changeTo(kind('raster'), { raster: 'slope.asc', crs: 'EPSG:31287', rotate_deg: 90 })).toEqual([]);
  expect(changeTo(kind('survey'), { points: 'a.xyz', crs: 'EPSG:31287', max_edge_m: 5 })).toEqual([]);
});

test('changing the kind removes settings that no longer apply', () => {
  const terrain = { points: 'a.xyz', crs: 'EPSG:31287', max_edge_m: 5 };
  expect(changeTo(kind('raster'), terrain)).toEqual([
    { remove: ['terrain', 'points'] },
    { remove: ['terrain', 'max_edge_m'] },
  ]);
  expect(changeTo(kind('section'), { raster: 'slope.asc', crs: 'EPSG:31287' })).toEqual([
    { remove: ['terrain', 'raster'] },
    { remove: ['terrain', 'crs'] },
    { set: ['terrain', 'section'], value: [] },
  ]);
});
