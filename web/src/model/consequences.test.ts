import { expect, test } from 'vitest';
import { consequences, removal } from './consequences';

const project = {
  material: [{ name: 'Rock' }, { name: 'Scree' }, { name: 'Soil' }],
  ground: { triangles: [0, 1, 2, 1] },
  seeder: [
    {
      type: 'line',
      points: [
        [0, 0],
        [1, 0],
      ],
      height_above_m: 1,
    },
  ],
};

test('places that a type of seeder does not have go with the old type', () =>
  expect(consequences(project, ['seeder', 0, 'type'], 'point')).toEqual([{ remove: ['seeder', 0, 'points'] }]));

test('other values change nothing else', () => expect(consequences(project, ['seeder', 0, 'rocks'], 5)).toEqual([]));

test('triangles keep their material when another goes, and have none when their own does', () =>
  expect(removal(project, ['material', 1])).toEqual([
    { remove: ['material', 1] },
    { set: ['ground', 'triangles'], value: [0, -1, 1, -1] },
  ]));
