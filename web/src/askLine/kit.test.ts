import { expect, test } from 'vitest';
import { kitSentence, kitShare, nearestIndex, percentText } from './kit';

const table = {
  heights_m: [2, 5],
  energies_kJ: [100, 3000],
  stopped: [[1, 2], [3, 931]],
  share: [[0.001, 0.002], [0.003, 0.931]],
  low: [[0, 0], [0, 0.914]],
  high: [[0.01, 0.01], [0.01, 0.946]],
};

test('the sentence of a kit has the numbers of the table', () => {
  expect(kitSentence(kitShare(table, 1, 1)!)).toBe('5 m and 3,000 kJ here stop 93.1 % (91.4 to 94.6 %) of the rocks that cross');
  expect(kitShare({ ...table, share: [[null, null], [null, null]] }, 1, 1)).toBeNull();
});
test('the kit nearest to the wanted one', () => {
  expect([0, 3.4, 3.6, 99].map((wanted) => nearestIndex(table.heights_m, wanted))).toEqual([0, 0, 1, 1]);
});
test('a share next to 0 or 100 % is not shown as such', () => {
  expect([0, 1, 0.5, 0.3721, 0.99996, 0.00002].map(percentText)).toEqual(['0 %', '100 %', '50 %', '37.2 %', '99.996 %', '0.002 %']);
  // Halves: of numbers that are above, at and below the share of rocks.
  expect([1905 / 2000, 201 / 400, 23 / 80, 0.1245].map(percentText)).toEqual(['95.3 %', '50.3 %', '28.8 %', '12.5 %']);
});
