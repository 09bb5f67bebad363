import { expect, test } from 'vitest';
import { following, placeAfter, stillOpen } from './following';

test('the index of an entry after others are deleted, added or changed', () => {
  expect(placeAfter(['a', 'b', 'c'], ['a', 'c'], 2)).toBe(1);
  expect(placeAfter(['a', 'b', 'c'], ['a', 'c'], 1)).toBeNull();
  expect(placeAfter(['a', 'b'], ['a', 'B'], 1)).toBe(1);
  expect(placeAfter(['a', 'a'], ['x', 'a', 'a'], 1)).toBe(2);
  // A new entry that is still being typed.
  expect(placeAfter(['a', 'b'], ['a'], 2)).toBe(1);
  expect(placeAfter(['a', 'b'], ['a', 'b', 'c'], 2)).toBe(2);
});

test('rows follow their entry', () => {
  const rows = [{ at: 0, cells: ['1', ''], replaces: null }];
  const seeders = (...names: string[]) => ({ seeder: names.map((name) => ({ name })) });
  const all = { 'terrain.section': rows, 'seeder.1.position': rows };
  expect(following(all, seeders('A', 'B'), seeders('B'))).toEqual({
    'terrain.section': rows,
    'seeder.0.position': rows,
  });
  expect(following(all, seeders('A', 'B'), seeders('A'))).toEqual({ 'terrain.section': rows });
});

test('a change of a row is dropped when the row is replaced', () => {
  const fresh = { at: 2, cells: ['1', ''], replaces: null };
  const changing = { at: 1, cells: ['', '5'], replaces: ['1', '5'] };
  const rows = {
    'terrain.section': [changing, fresh],
    'seeder.0.position': [{ at: 0, cells: ['', '5'], replaces: ['1', '5'] }],
  };
  const values = (place: number[]) => ({ terrain: { section: [[0, 0], place] }, seeder: [{ position: place }] });
  expect(stillOpen(rows, values([1, 5]))).toEqual(rows);
  expect(stillOpen(rows, values([7, 8]))).toEqual({ 'terrain.section': [fresh] });
});
