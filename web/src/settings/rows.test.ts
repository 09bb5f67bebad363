import { describe, expect, test } from 'vitest';
import { cellsOf, overlaid, rowEdits, rowValue } from './rows';

test('short rows are filled with empty cells', () =>
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

test('only a complete row has a value', () => {
  expect(rowValue(['1', '2', 'surface'], 3)).toEqual([1, 2, 'surface']);
  expect(rowValue(['1', '2', ''], 2)).toEqual([1, 2]);
  expect(rowValue(['1', '2', ''], 3)).toBeUndefined();
  expect(rowValue(['1', '', '3'], 2)).toBeUndefined();
});

test('a pasted block overwrites cells and adds rows', () =>
  expect(overlaid([['1', '2']], [['8', '9', '10'], ['11']], 0, 1, 2)).toEqual([
    ['1', '8'],
    ['', '11'],
  ]));

describe('minimal edits', () => {
  const path = ['terrain', 'section'];
  const before = [
    [0, 0],
    [1, -1],
    [2, -2],
  ];
  test('change one cell', () =>
    expect(
      rowEdits(path, before, [
        [0, 0],
        [1, -1.5],
        [2, -2],
      ]),
    ).toEqual([{ set: [...path, 1, 1], value: -1.5 }]));
  test('add a row', () =>
    expect(rowEdits(path, before, [...before, [3, -3]])).toEqual([{ set: [...path, 3], value: [3, -3] }]));
  test('remove a row', () =>
    expect(
      rowEdits(path, before, [
        [0, 0],
        [2, -2],
      ]),
    ).toEqual([{ remove: [...path, 1] }]));
  test('remove the last row', () =>
    expect(rowEdits(path, before, before.slice(0, 2))).toEqual([{ remove: [...path, 2] }]));
  test('none if nothing changed', () => expect(rowEdits(path, before, before)).toEqual([]));
  test('remove all rows, or add the first', () => {
    expect(rowEdits(path, before, [])).toEqual([{ set: path, value: [] }]);
    expect(rowEdits(path, undefined, before)).toEqual([{ set: path, value: before }]);
  });
});
