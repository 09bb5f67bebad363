import { expect, test } from 'vitest';
import { consequences, removal } from './consequences';

const project = {
  material: [{ name: 'Rock' }, { name: 'Scree' }, { name: 'Soil' }],
  area: [{ name: 'Rock', material: 'Scree' }, { material: 'Rock' }],
  ground: { default: 'Rock', segments: ['Rock', 'Scree', 'Rock'], triangles: [0, 1, 2, 1] },
  collector: [{ name: 'Road' }],
  design: { lines: ['Road'], protect: 'Road' },
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

test('who names a material that is renamed', () =>
  expect(consequences(project, ['material', 0, 'name'], 'Granite')).toEqual([
    { set: ['ground', 'default'], value: 'Granite' },
    { set: ['ground', 'segments', 0], value: 'Granite' },
    { set: ['ground', 'segments', 2], value: 'Granite' },
    { set: ['area', 1, 'material'], value: 'Granite' },
  ]));

test('who names a collector that is renamed', () =>
  expect(consequences(project, ['collector', 0, 'name'], 'Street')).toEqual([
    { set: ['design', 'lines', 0], value: 'Street' },
    { set: ['design', 'protect'], value: 'Street' },
  ]));

test('places that a type of seeder does not have go with the old type', () =>
  expect(consequences(project, ['seeder', 0, 'type'], 'point')).toEqual([{ remove: ['seeder', 0, 'points'] }]));

test('other values change nothing else', () => expect(consequences(project, ['seeder', 0, 'rocks'], 5)).toEqual([]));

test('triangles keep their material when another goes', () =>
  expect(removal(project, ['material', 1])).toEqual([
    { remove: ['material', 1] },
    { set: ['ground', 'triangles'], value: [0, 0, 1, 0] },
  ]));
