import { expect, test } from 'vitest';
import { valuesOf } from '../toml/values';
import { fileNameOf, firstText } from './newProject';

test('the initial text is valid TOML', () => {
  expect(valuesOf(firstText('A "b"', { kind: 'section' }))).toEqual({ name: 'A "b"', terrain: { section: [] } });
  expect(valuesOf(firstText('A', { kind: 'space' }))).toEqual({ name: 'A' });
  expect(valuesOf(firstText('A', { kind: 'file', name: 'x\\y.tif', key: 'raster' }))).toEqual({
    name: 'A',
    terrain: { raster: 'x\\y.tif' },
  });
});

test('a name becomes an unused file name', () => {
  expect(fileNameOf('Cliff above B12', [])).toBe('cliff-above-b12.toml');
  expect(fileNameOf('Höhe ../x', [])).toBe('hohe-x.toml');
  expect(fileNameOf('A', ['A.toml', 'a-2.toml'])).toBe('a-3.toml');
  expect(fileNameOf('...', [])).toBe('project.toml');
});
