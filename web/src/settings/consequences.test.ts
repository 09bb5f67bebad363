import { describe, expect, test } from 'vitest';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
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

test('changing the type of a seeder removes the settings of the old type', () =>
  expect(consequences(project, ['seeder', 0, 'type'], 'point')).toEqual([{ remove: ['seeder', 0, 'points'] }]));

test('changing another value has no consequences', () => expect(consequences(project, ['seeder', 0, 'rocks'], 5)).toEqual([]));

test('deleting a material keeps the materials of other triangles and unassigns its own', () =>
  expect(removal(project, ['material', 1])).toEqual([
    { remove: ['material', 1] },
    { set: ['ground', 'triangles'], value: [0, -1, 1, -1] },
  ]));

describe('materials and deviations follow their segments and vertices', () => {
  const slope = `[terrain]
section = [[0, 30], [10, 20], [20, 10], [30, 0]]
section_std_dev_m = [[0, 0], [0.1, 0.2], [0.3, 0.4], [0, 0]]

[ground]
segments = ["Rock", "Scree", "Soil"]
`;
  const section = (valuesOf(slope).terrain as { section: number[][] }).section;
  const after = (next: number[][], text = slope) => {
    const path = ['terrain', 'section'];
    return valuesOf(edited(text, [{ set: path, value: next }, ...consequences(valuesOf(text), path, next)]));
  };
  const longer = section.toSpliced(2, 0, [15, 16]);

  test('a new vertex splits its segment and has no deviation', () =>
    expect(after(longer)).toEqual({
      terrain: { section: longer, section_std_dev_m: [[0, 0], [0.1, 0.2], [0, 0], [0.3, 0.4], [0, 0]] },
      ground: { segments: ['Rock', 'Scree', 'Scree', 'Soil'] },
    }));
  test('when two segments merge, the material of the first is kept', () =>
    expect(after(section.toSpliced(1, 1))).toEqual({
      terrain: { section: section.toSpliced(1, 1), section_std_dev_m: [[0, 0], [0.3, 0.4], [0, 0]] },
      ground: { segments: ['Rock', 'Soil'] },
    }));
  test('moving a vertex has no consequences', () =>
    expect(consequences(valuesOf(slope), ['terrain', 'section'], section.with(1, [11, 19]))).toEqual([]));
  test('a list that is too short stays too short, with its materials in place', () => {
    const short = slope.replace(', "Soil"', '');
    expect(after(longer, short).ground).toEqual({ segments: ['Rock', 'Scree', 'Scree'] });
    expect(after(section.toSpliced(1, 1), short).ground).toEqual({ segments: ['Rock'] });
  });
  test('surplus entries stay', () => {
    const long = slope.replace('"Soil"]', '"Soil", "Bog"]');
    expect(after(longer, long).ground).toEqual({ segments: ['Rock', 'Scree', 'Scree', 'Soil', 'Bog'] });
  });
  test('without such lists there are no consequences', () =>
    expect(consequences({ terrain: { section } }, ['terrain', 'section'], longer)).toEqual([]));
});

test('triangles keep their material when others are added or deleted', () => {
  const triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 5]]; // prettier-ignore
  const mesh = { ...project, ground: { default: 'Scree', triangles: [0, 1, 2, 1] }, terrain: { triangles } };
  const path = ['terrain', 'triangles'];
  expect(consequences(mesh, path, triangles.toSpliced(1, 1))).toEqual([{ remove: ['ground', 'triangles', 1] }]);
  expect(consequences(mesh, path, [...triangles, [4, 5, 6]])).toEqual([
    { set: ['ground', 'triangles', 4], value: 1 },
  ]);
});

describe('triangles keep their corners when vertices are added or deleted', () => {
  const mesh = `[terrain]
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 2, 0]]
triangles = [[0, 1, 2], [1, 3, 2], [1, 4, 3]]

[ground]
triangles = [0, 1, 2]
`;
  const vertices = (valuesOf(mesh).terrain as { vertices: number[][] }).vertices;
  const path = ['terrain', 'vertices'];
  const after = (next: number[][]) => {
    const values = valuesOf(edited(mesh, [{ set: path, value: next }, ...consequences(valuesOf(mesh), path, next)]));
    return [(values.terrain as { triangles: number[][] }).triangles, (values.ground as { triangles: number[] }).triangles];
  };
  test('deleting a vertex deletes its triangles with their materials', () => {
    expect(after(vertices.toSpliced(0, 1))).toEqual([[[0, 2, 1], [0, 3, 2]], [1, 2]]); // prettier-ignore
    expect(after(vertices.slice(0, 4))).toEqual([[[0, 1, 2], [1, 3, 2]], [0, 1]]); // prettier-ignore
  });
  test('a new vertex shifts the indices after it', () =>
    expect(after(vertices.toSpliced(2, 0, [9, 9, 9]))[0]).toEqual([[0, 1, 3], [1, 4, 3], [1, 5, 4]])); // prettier-ignore
  test('appending, moving or replacing vertices has no consequences', () => {
    const others = [[...vertices, [5, 5, 5]], vertices.with(2, [7, 7, 7]), [[8, 0, 0], [0, 8, 0], [0, 0, 8]]]; // prettier-ignore
    for (const next of others) expect(consequences(valuesOf(mesh), path, next)).toEqual([]);
  });
});
