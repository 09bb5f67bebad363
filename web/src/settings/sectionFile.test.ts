import { expect, test } from 'vitest';
import { sectionEdits } from './sectionFile';

test('a section from a file replaces the terrain, and leaves nothing of a former section', () => {
  const set = { set: ['terrain', 'section'], value: 'profile.csv' };
  expect(sectionEdits('profile.csv', {})).toEqual([set]);
  expect(sectionEdits('profile.csv', { raster: 'dem.tif' })).toEqual([{ remove: ['terrain', 'raster'] }, set]);
  const former = { section: 'old.dxf', section_layer: 'GROUND', section_tolerance_m: 0.1, width_m: 20 };
  expect(sectionEdits('profile.csv', former)).toEqual([
    { remove: ['terrain', 'section_layer'] },
    { remove: ['terrain', 'section_tolerance_m'] },
    { remove: ['terrain', 'width_m'] },
    set,
  ]);
});
