import { describe, expect, test } from 'vitest';
import { placeInTable, sentencesOf, settled, withWaiting, type Row } from './waitingRows';

const fresh = (...cells: string[]): Row => ({ cells, given: null });
const kept = (...cells: string[]): Row => ({ cells, given: cells });

test('complete rows are stored, incomplete ones wait at their position', () => {
  const pasted = [fresh('0', '0'), fresh('1', ''), fresh('2', '-2')];
  const { rows, waiting } = settled(pasted, 2);
  expect(rows).toEqual([
    [0, 0],
    [2, -2],
  ]);
  expect(waiting).toEqual([{ at: 1, cells: ['1', ''], replaces: null }]);
  const cells = [['0', '0'], ['2', '-2']]; // prettier-ignore
  expect(withWaiting(cells, waiting)).toEqual([kept('0', '0'), fresh('1', ''), kept('2', '-2')]);
});

test('the project keeps a changed row until the new one is complete', () => {
  const { rows, waiting } = settled([kept('0', '0'), { cells: ['', '-1'], given: ['1', '-1'] }], 2);
  expect(rows).toEqual([
    [0, 0],
    [1, -1],
  ]);
  const cells = [['0', '0'], ['1', '-1']]; // prettier-ignore
  expect(withWaiting(cells, waiting)[1]).toEqual({ cells: ['', '-1'], given: ['1', '-1'] });
  // Undone or redrawn in the meantime.
  expect(withWaiting([['0', '0'], ['5', '-5']], waiting)[1]).toEqual(kept('5', '-5')); // prettier-ignore
  expect(withWaiting([['0', '0']], waiting)).toEqual([kept('0', '0')]);
});

test('a row that is incomplete in the file is not held back', () => {
  const { rows, waiting } = settled([kept('3', ''), kept('1', '2')], 2);
  expect(rows).toEqual([[3], [1, 2]]);
  expect(waiting).toEqual([]);
});

test('waiting rows are shown even if the project now has fewer rows', () =>
  expect(withWaiting([['0', '0']], [{ at: 7, cells: ['1', ''], replaces: null }])).toEqual([
    kept('0', '0'),
    fresh('1', ''),
  ]));

test('the index in the table of a row of the project', () => {
  const waiting = [
    { at: 0, cells: ['1', ''], replaces: null },
    { at: 2, cells: ['', '2'], replaces: ['1', '2'] },
    { at: 3, cells: ['3', ''], replaces: null },
  ];
  expect([0, 1, 2].map((number) => placeInTable(waiting, number))).toEqual([1, 2, 4]);
});

describe('sentences', () => {
  const row = (at: number, replaces: string[] | null = null) => ({ at, cells: ['1', ''], replaces });
  test('describe one row', () =>
    expect(sentencesOf([row(19)])).toEqual(['Row 20 is incomplete and not part of the project yet.']));
  test('describe several rows of both kinds', () =>
    expect(sentencesOf([row(0), row(2), row(3, ['1', '2']), row(11)])).toEqual([
      'Rows 1, 3 and 12 are incomplete and not part of the project yet.',
      'Row 4 is incomplete; the project keeps the previous values.',
    ]));
  test('do not mention empty rows', () =>
    expect(sentencesOf([{ at: 0, cells: ['', ''], replaces: null }])).toEqual([]));
});
