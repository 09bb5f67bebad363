import { describe, expect, test } from 'vitest';
import { cellsOf, overlaid, rowEdits, rowValue } from './rows';

test('cells of rows that are too short are empty', () =>
  expect(
    cellsOf(
      [
        [1, 2, 'surface'],
        [3, 4],
      ],
      3,
    ),
  ).toEqual([
    ['1', '2', 'surface'],
    ['3', '4', ''],
  ]));

test('a row is taken when it is complete', () => {
  expect(rowValue(['1', '2', 'surface'], 3)).toEqual([1, 2, 'surface']);
  expect(rowValue(['1', '2', ''], 2)).toEqual([1, 2]);
  expect(rowValue(['1', '2', ''], 3)).toBeUndefined();
  expect(rowValue(['1', '', '3'], 2)).toBeUndefined();
});

test('a block is laid over cells, and adds rows', () =>
  expect(overlaid([['1', '2']], [['8', '9', '10'], ['11']], 0, 1, 2)).toEqual([
    ['1', '8'],
    ['', '11'],
  ]));

describe('the fewest edits', () => {
  const path = ['terrain', 'section'];
  const before = [
    [0, 0],
    [1, -1],
    [2, -2],
  ];
  test('one cell', () =>
    expect(
      rowEdits(path, before, [
        [0, 0],
        [1, -1.5],
        [2, -2],
      ]),
    ).toEqual([{ set: [...path, 1, 1], value: -1.5 }]));
  test('a row more', () =>
    expect(rowEdits(path, before, [...before, [3, -3]])).toEqual([{ set: [...path, 3], value: [3, -3] }]));
  test('a row less', () =>
    expect(
      rowEdits(path, before, [
        [0, 0],
        [2, -2],
      ]),
    ).toEqual([{ remove: [...path, 1] }]));
  test('the last row less', () =>
    expect(rowEdits(path, before, before.slice(0, 2))).toEqual([{ remove: [...path, 2] }]));
  test('nothing', () => expect(rowEdits(path, before, before)).toEqual([]));
  test('all gone, or none before', () => {
    expect(rowEdits(path, before, [])).toEqual([{ set: path, value: [] }]);
    expect(rowEdits(path, undefined, before)).toEqual([{ set: path, value: before }]);
  });
});
