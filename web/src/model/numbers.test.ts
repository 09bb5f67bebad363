import { describe, expect, test } from 'vitest';
import { numberOf, pastedRows, typedValue, withoutNames } from './numbers';

describe('numbers as they are typed', () => {
  test.each([
    ['1', 1],
    [' 0.35 ', 0.35],
    ['.5', 0.5],
    ['5.', 5],
    ['-1e-3', -0.001],
    ['+2', 2],
    ['\u22123', -3],
    ['inf', Infinity],
    ['9007199254740993', 9007199254740993n],
    ['-9223372036854775808', -(2n ** 63n)],
    ['1e-300', 1e-300],
    ['0e5', 0],
  ])('%s', (text, value) => expect(numberOf(text)).toBe(value));
  test.each(['', '-', '0,8', '1e', 'abc', '1 2', '0x10', 'Infinity', 'NaN'])('"%s" is none', (text) =>
    expect(numberOf(text)).toBeUndefined(),
  );
  const lost = ['1e999', '-1e999', '1e-999', '9223372036854775808', '99999999999999999999'];
  test.each(lost)('%s cannot be kept', (text) => {
    expect(numberOf(text)).toBeUndefined();
    expect(typedValue(text)).toBe(text);
  });
  test('what is no number goes to the engine as it is', () => {
    expect(typedValue('0,8')).toBe('0,8');
    expect(typedValue('  ')).toBeUndefined();
  });
});

describe('rows from a spreadsheet', () => {
  test('tabs', () =>
    expect(pastedRows('0\t0\r\n3.1\t-12.2\r\n')).toEqual([
      ['0', '0'],
      ['3.1', '-12.2'],
    ]));
  test('decimal commas between tabs or semicolons', () => {
    expect(pastedRows('3,1\t-12,2')).toEqual([['3.1', '-12.2']]);
    expect(pastedRows('3,1;-12,2\n1;2')).toEqual([
      ['3.1', '-12.2'],
      ['1', '2'],
    ]);
  });
  test('commas and blanks as separators', () => {
    expect(pastedRows('1, 2, 3')).toEqual([['1', '2', '3']]);
    expect(pastedRows('  1   2\t3'.replace('\t', ' '))).toEqual([['1', '2', '3']]);
  });
  test('a heading, empty lines and quotes', () => expect(pastedRows('X\tY\n\n"1"\t"2"\n')).toEqual([['1', '2']]));
  test('a row of numbers that cannot be kept is no heading', () =>
    expect(pastedRows('1e999;1e999')).toEqual([['1e999', '1e999']]));
  test('a comma at the end of every line', () =>
    expect(pastedRows('1,2,\n3,4,')).toEqual([
      ['1', '2'],
      ['3', '4'],
    ]));
  test('the names of vertices go', () => {
    const rows = pastedRows('Vertex\tX\tY\tZ\nA\t-10\t10\t16.32993\nB\t10\t10\t16.32993');
    expect(withoutNames(rows, 3)).toEqual([
      ['-10', '10', '16.32993'],
      ['10', '10', '16.32993'],
    ]);
  });
  test('numbers that count the rows go, others stay', () => {
    expect(
      withoutNames(
        [
          ['1', '5', '6'],
          ['2', '7', '8'],
        ],
        2,
      ),
    ).toEqual([
      ['5', '6'],
      ['7', '8'],
    ]);
    expect(
      withoutNames(
        [
          ['4', '5', '6'],
          ['2', '7', '8'],
        ],
        2,
      ),
    ).toEqual([
      ['4', '5', '6'],
      ['2', '7', '8'],
    ]);
  });
});
