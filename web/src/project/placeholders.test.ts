import { expect, test } from 'vitest';
import type { Problem } from '../api/types';
import { valuesOf } from '../toml/values';
import { withPlaceholders, withTerrainProblems } from './placeholders';

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

test('problems of the terrain are reported even while other parts are missing', () => {
  const missing = { ...error(''), what: '[[material]] is missing' };
  const ofTerrain = {
    ...error('terrain.lines'),
    file: 'a.toml',
    line: 9,
    text: 'a.toml:9: lines has an attribute that is not UTF-8',
  };
  expect(withTerrainProblems([missing], [error('seeder.0.position'), ofTerrain])).toEqual([
    missing,
    { ...ofTerrain, line: 0, text: 'a.toml: lines has an attribute that is not UTF-8' },
  ]);
  expect(withTerrainProblems([ofTerrain], [ofTerrain])).toEqual([ofTerrain]);
});

test('placeholders replace a missing material and seeder', () =>
  expect(valuesOf(withPlaceholders(terrain, [error(''), error('')])!)).toMatchObject({
    material: [{}],
    seeder: [{ position: [5, 1], rocks: 1 }],
  }));

test('a section in a file is met where it lies', () => {
  const inFile = '[terrain]\nsection = "profile.csv"\n';
  const off = { ...error('seeder.0.position'), why: 'the section extends from x = 100 to 140' };
  expect(valuesOf(withPlaceholders(inFile, [error('')])!)).toMatchObject({ seeder: [{ position: [0, 'surface'] }] });
  expect(valuesOf(withPlaceholders(inFile, [error(''), off])!)).toMatchObject({ seeder: [{ position: [120, 'surface'] }] });
});

test('entries with problems are removed, the last first', () => {
  const text = `${terrain}[[material]]\nname = "A"\nrn = 3\n[[seeder]]\nrocks = 0\n[[seeder]]\nrocks = 4\n[[seeder]]\nrocks = 0\n[ground]\ndefault = "B"\n`;
  const next = withPlaceholders(
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

test('there is no placeholder for terrain', () => {
  expect(withPlaceholders(terrain, [error('terrain.section.1')])).toBeNull();
  expect(withPlaceholders('name = "A"', [error('')])).toBeNull();
});

test('entries with warnings stay', () => {
  const text = `${terrain}[[material]]\nname = "A"\n[[seeder]]\nrocks = 1\n`;
  expect(withPlaceholders(text, [{ ...error('seeder.0.rocks'), severity: 'warning' }])).toBeNull();
});

test('the placeholder seeder is moved to the middle of the terrain', () => {
  const text = '[terrain]\nraster = "a.tif"\n[[material]]\nname = "A"\n';
  const first = withPlaceholders(text, [error('')])!;
  expect(valuesOf(first)).toMatchObject({ seeder: [{ position: [0, 0, 0] }] });
  const off = {
    ...error('seeder.0'),
    why: 'on plan the terrain lies within x = 652002.5 to 652747.5, y = 5234002.5 to 5234547.5',
  };
  expect(valuesOf(withPlaceholders(first, [off])!)).toMatchObject({ seeder: [{ position: [652375, 5234275, 0] }] });
});
