import { expect, test } from 'vitest';
import { movedRow, shapeOf, valueOf } from './shapes';

const values = {
  terrain: { section: [[0, 10], [5, 3], [20, 0]] },
  seeder: [{ position: [1, 'surface'] }, { type: 'line', points: [[1, 2, 'surface'], [3, 4, 9]] }, { polygon: 'cliff.gpkg' }, { position: ['x', 2] }],
  barrier: [{ line: 15 }, { line: [[0, 0], [0, 50]] }],
  area: [{ polygon: [[0, 0], [1, 0], [1, 1]] }],
  forest: [{ polygons: 'stands.gpkg' }, { polygon: [[0, 0], [1, 0], [1, 1]] }],
};

test('vertices are those of the project', () => {
  expect(shapeOf(values, ['terrain'], true)).toEqual({ path: ['terrain', 'section'], kind: 'line', rows: values.terrain.section, least: 2 });
  expect(shapeOf(values, ['seeder', 0], true)).toEqual({ path: ['seeder', 0, 'position'], kind: 'points', rows: [[1, 'surface']], least: 1 });
  expect(shapeOf(values, ['seeder', 1], false)?.rows).toEqual([[1, 2, 'surface'], [3, 4, 9]]);
  expect(shapeOf(values, ['barrier', 0], true)).toEqual({ path: ['barrier', 0, 'line'], kind: 'points', rows: [[15]], least: 1 });
  expect(shapeOf(values, ['barrier', 1], false)?.kind).toBe('line');
  expect(shapeOf(values, ['area', 0], false)?.kind).toBe('polygon');
  expect(shapeOf(values, ['forest', 0], false)).toBe(null);
  expect(shapeOf(values, ['forest', 1], false)?.kind).toBe('polygon');
});

test('what has no numbers cannot be moved', () => {
  for (const [entry, is2d] of [[['terrain'], false], [['seeder', 2], false], [['seeder', 3], true], [['seeder', 9], false], [['material', 0], false], [['seeder', 0], false]] as const)
    expect(shapeOf(values, entry, is2d)).toBeNull();
});

test('a value has the form that it had', () => {
  const [seeder, barrier] = [shapeOf(values, ['seeder', 0], true)!, shapeOf(values, ['barrier', 0], true)!];
  expect(valueOf(seeder, [[2, 'surface']])).toEqual([2, 'surface']);
  expect(valueOf(barrier, [[16]])).toBe(16);
  expect(valueOf(shapeOf(values, ['barrier', 1], false)!, [[0, 1], [0, 2]])).toEqual([[0, 1], [0, 2]]);
  expect(movedRow([1, 2, 'surface'], [5, 6], 9)).toEqual([5, 6, 'surface']);
  expect(movedRow([1, 2, 3], [5, 6], 9)).toEqual([5, 6, 9]);
  expect(movedRow([1, 2, 3], [5, 6], null)).toEqual([5, 6, 3]);
  expect(movedRow([0, 10], [1, 2], null)).toEqual([1, 2]);
});
