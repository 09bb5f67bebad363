import { describe, expect, test } from 'vitest';
import { placeInTable, sentencesOf, settled, withWaiting, type Row } from './waitingRows';

const fresh = (...cells: string[]): Row => ({ cells, given: null });
const kept = (...cells: string[]): Row => ({ cells, given: cells });

test('what is complete is taken, what is not waits at its place', () => {
  const pasted = [fresh('0', '0'), fresh('1', ''), fresh('2', '-2')];
  const { rows, waiting } = settled(pasted, 2);
  expect(rows).toEqual([
    [0, 0],
    [2, -2],
  ]);
  expect(waiting).toEqual([{ at: 1, cells: ['1', ''], over: null }]);
  const cells = [['0', '0'], ['2', '-2']]; // prettier-ignore
  expect(withWaiting(cells, waiting)).toEqual([kept('0', '0'), fresh('1', ''), kept('2', '-2')]);
});

test('a row that is changed stays in the project as it was until it is complete', () => {
  const { rows, waiting } = settled([kept('0', '0'), { cells: ['', '-1'], given: ['1', '-1'] }], 2);
  expect(rows).toEqual([
    [0, 0],
    [1, -1],
  ]);
  const cells = [['0', '0'], ['1', '-1']]; // prettier-ignore
  expect(withWaiting(cells, waiting)[1]).toEqual({ cells: ['', '-1'], given: ['1', '-1'] });
  // Undone, or drawn anew meanwhile.
  expect(withWaiting([['0', '0'], ['5', '-5']], waiting)[1]).toEqual(kept('5', '-5')); // prettier-ignore
  expect(withWaiting([['0', '0']], waiting)).toEqual([kept('0', '0')]);
});

test('a row that the file has incomplete is left to the engine', () => {
  const { rows, waiting } = settled([kept('3', ''), kept('1', '2')], 2);
  expect(rows).toEqual([[3], [1, 2]]);
  expect(waiting).toEqual([]);
});

test('rows that wait are shown though the project has fewer than before', () =>
  expect(withWaiting([['0', '0']], [{ at: 7, cells: ['1', ''], over: null }])).toEqual([
    kept('0', '0'),
    fresh('1', ''),
  ]));

test('the place of a row of the project in the table', () => {
  const waiting = [
    { at: 0, cells: ['1', ''], over: null },
    { at: 2, cells: ['', '2'], over: ['1', '2'] },
    { at: 3, cells: ['3', ''], over: null },
  ];
  expect([0, 1, 2].map((number) => placeInTable(waiting, number))).toEqual([1, 2, 4]);
});

describe('sentences', () => {
  const row = (at: number, over: string[] | null = null) => ({ at, cells: ['1', ''], over });
  test('one', () =>
    expect(sentencesOf([row(19)])).toEqual(['Row 20 is not complete: the project does not have it yet.']));
  test('several, of both kinds', () =>
    expect(sentencesOf([row(0), row(2), row(3, ['1', '2']), row(11)])).toEqual([
      'Rows 1, 3 and 12 are not complete: the project does not have them yet.',
      'Row 4 is not complete: the project keeps it as before.',
    ]));
  test('none of rows in which nothing is typed', () =>
    expect(sentencesOf([{ at: 0, cells: ['', ''], over: null }])).toEqual([]));
});
