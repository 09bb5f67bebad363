import { expect, test } from 'vitest';
import type { StationAnswer } from '../api/line';
import { envelopeOf, stationsAlong } from './stations';

test('stations are across the line, half a spacing from its ends', () => {
  const found = stationsAlong([[0, 0], [10, 0]], 2, 2);
  expect(found).toEqual([
    { distance: 2.5, line: [[2.5, 2], [2.5, -2]] },
    { distance: 7.5, line: [[7.5, 2], [7.5, -2]] },
  ]);
});

test('at a bend they turn with the line; points that repeat do not matter', () => {
  const found = stationsAlong([[0, 0], [4, 0], [4, 0], [4, 8]], 1, 3);
  expect(found.map(({ distance }) => distance)).toEqual([2, 6, 10]);
  expect(found[1]!.line).toEqual([[3, 2], [5, 2]]);
  expect(stationsAlong([[1, 1], [1, 1]], 1, 5)).toEqual([]);
});

test('energies are shown in kJ, and nothing where no rock passes', () => {
  const none = { whole: { maxima: null, percentiles: {} } } as StationAnswer;
  const some = { whole: { maxima: { ke_total_J: 5000 }, percentiles: { ke_total_J: { '95': [4000, 3000, null] } } } } as unknown as StationAnswer;
  const off = { length_m: null, whole: null };
  const { label, curves } = envelopeOf([1, 2, 3], [none, some, off], 'ke_total_J', { unit: 'kJ', per: 1000 });
  expect(label).toBe('Total energy [kJ]');
  expect(curves.map(({ values }) => values)).toEqual([[null, 5, null], [null, 4, null]]);
});
