import { expect, test } from 'vitest';
import type { Problem } from '../api/types';
import { valuesOf } from '../toml/edit';
import { withStandIns, withTerrainOf } from './standIn';

const error = (path: string): Problem => ({
  severity: 'error',
  path,
  file: '',
  line: 0,
  where: '',
  what: '',
  why: '',
  hint: '',
  text: path,
});
const terrain = '[terrain]\nsection = [[5, 1], [10, -5]]\n';

test('what is wrong with the terrain is told as soon as something stands in for the rest', () => {
  const missing = { ...error(''), what: '[[material]] is missing' };
  const ofTerrain = {
    ...error('terrain.lines'),
    file: 'a.toml',
    line: 9,
    text: 'a.toml:9: lines has an attribute that is not UTF-8',
  };
  expect(withTerrainOf([missing], [error('seeder.0.position'), ofTerrain])).toEqual([
    missing,
    { ...ofTerrain, line: 0, text: 'a.toml: lines has an attribute that is not UTF-8' },
  ]);
  expect(withTerrainOf([ofTerrain], [ofTerrain])).toEqual([ofTerrain]);
});

test('a material and a seeder stand in where there are none', () =>
  expect(valuesOf(withStandIns(terrain, [error(''), error('')])!)).toMatchObject({
    material: [{}],
    seeder: [{ position: [5, 1], rocks: 1 }],
  }));

test('what has a problem is removed, the last first', () => {
  const text = `${terrain}[[material]]\nname = "A"\nrn = 3\n[[seeder]]\nrocks = 0\n[[seeder]]\nrocks = 4\n[[seeder]]\nrocks = 0\n[ground]\ndefault = "B"\n`;
  const next = withStandIns(
    text,
    ['material.0.rn', 'seeder.0', 'seeder.2.rocks', 'seeder.2.mass_kg', 'ground.default'].map(error),
  );
  expect(valuesOf(next!)).toEqual({
    terrain: {
      section: [
        [5, 1],
        [10, -5],
      ],
    },
    material: [{ name: 'A' }],
    seeder: [{ rocks: 4 }],
    ground: {},
  });
});

test('nothing stands in for a terrain', () => {
  expect(withStandIns(terrain, [error('terrain.section.1')])).toBeNull();
  expect(withStandIns('name = "A"', [error('')])).toBeNull();
});

test('warnings take nothing away', () => {
  const text = `${terrain}[[material]]\nname = "A"\n[[seeder]]\nrocks = 1\n`;
  expect(withStandIns(text, [{ ...error('seeder.0.rocks'), severity: 'warning' }])).toBeNull();
});

test('off a terrain far from the origin, it stands in the middle of it', () => {
  const text = '[terrain]\nraster = "a.tif"\n[[material]]\nname = "A"\n';
  const first = withStandIns(text, [error('')])!;
  expect(valuesOf(first)).toMatchObject({ seeder: [{ position: [0, 0, 0] }] });
  const off = {
    ...error('seeder.0'),
    why: 'on plan the terrain lies within x = 652002.5 to 652747.5, y = 5234002.5 to 5234547.5',
  };
  expect(valuesOf(withStandIns(first, [off])!)).toMatchObject({ seeder: [{ position: [652375, 5234275, 0] }] });
});
