import { describe, expect, test } from 'vitest';
import { readPasted, withoutNames, type Commas } from './pasted';

const rowsOf = (text: string, commas?: Commas) => readPasted(text, commas).rows;
const column = (text: string, commas?: Commas) => rowsOf(text, commas).map((row) => row.at(-1));

describe('rows from a spreadsheet', () => {
  test('tabs', () =>
    expect(rowsOf('0\t0\r\n3.1\t-12.2\r\n')).toEqual([
      ['0', '0'],
      ['3.1', '-12.2'],
    ]));
  test('decimal commas between tabs or semicolons', () => {
    expect(rowsOf('3,1\t-12,2')).toEqual([['3.1', '-12.2']]);
    expect(rowsOf('3,1;-12,2\n1;2')).toEqual([
      ['3.1', '-12.2'],
      ['1', '2'],
    ]);
  });
  test('commas and blanks as separators', () => {
    expect(rowsOf('1, 2, 3')).toEqual([['1', '2', '3']]);
    expect(rowsOf('  1   2\t3'.replace('\t', ' '))).toEqual([['1', '2', '3']]);
  });
  test('a heading, empty lines and quotes', () => expect(rowsOf('X\tY\n\n"1"\t"2"\n')).toEqual([['1', '2']]));
  test('a row of numbers that cannot be represented is not a heading', () =>
    expect(rowsOf('1e999;1e999')).toEqual([['1e999', '1e999']]));
  test('a comma at the end of every line', () =>
    expect(rowsOf('1,2,\n3,4,')).toEqual([
      ['1', '2'],
      ['3', '4'],
    ]));
  test('a column of vertex names is removed', () => {
    const rows = rowsOf('Vertex\tX\tY\tZ\nA\t-10\t10\t16.32993\nB\t10\t10\t16.32993');
    expect(withoutNames(rows, 3)).toEqual([
      ['-10', '10', '16.32993'],
      ['10', '10', '16.32993'],
    ]);
  });
  test('a column of row numbers is removed, other numbers stay', () => {
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

describe('commas and points', () => {
  const thousands = ['0\t1,250', '10\t1,240', '20\t998'].join('\n');
  test('an ambiguous comma is reported and its cell stays as it is', () => {
    expect(readPasted(thousands)).toEqual({
      rows: [
        ['0', '1,250'],
        ['10', '1,240'],
        ['20', '998'],
      ],
      open: { number: '1,250', readings: ['separate thousands', 'are decimal'] },
    });
    expect(readPasted(thousands, 'separate thousands').open).toBeNull();
    expect(column(thousands, 'separate thousands')).toEqual(['1250', '1240', '998']);
    expect(column(thousands, 'are decimal')).toEqual(['1.250', '1.240', '998']);
  });
  test.each([
    ['both signs in a number', ['1,250.5', '1,240', '998'], ['1250.5', '1240', '998']],
    ['both signs, the other way', ['1.250,5', '1.240', '998,25'], ['1250.5', '1240', '998.25']],
    ['other decimals', ['1,240', '998.25'], ['1240', '998.25']],
    ['other decimals with commas', ['1,240', '998,25'], ['1.240', '998.25']],
    ['no thousands after a leading zero', ['1,240', '0,998'], ['1.240', '0.998']],
    ['two commas', ['1,234,567', '1,240'], ['1234567', '1240']],
    ['a sign and an exponent', ['-1,250.5', '1.5e3'], ['-1250.5', '1.5e3']],
    ['points alone', ['16.329', '1.240'], ['16.329', '1.240']],
  ])('%s', (_what, cells, numbers) => {
    const pasted = readPasted(cells.map((cell, k) => `${k}\t${cell}`).join('\n'));
    expect(pasted.rows.map((row) => row[1])).toEqual(numbers);
    expect(pasted.open).toBeNull();
  });
  test('another column can decide', () => expect(column('0.5\t1,250\n1.5\t1,240')).toEqual(['1250', '1240']));
  test('if cells contradict each other, each is read on its own', () => {
    const pasted = readPasted('0.5\t1,5\n0.75\t1,240');
    expect(pasted.rows).toEqual([
      ['0.5', '1.5'],
      ['0.75', '1,240'],
    ]);
    expect(pasted.open?.number).toBe('1,240');
  });
  test('a single column is not split at its commas', () => {
    const open = (text: string) => readPasted(text).open;
    expect(rowsOf('1,100\n1,090\n998')).toEqual([['1,100'], ['1,090'], ['998']]);
    expect(open('1,100\n1,090')?.readings).toEqual(['separate thousands', 'are decimal', 'separate columns']);
    expect(open('1,100.5\n1,090')?.readings).toEqual(['separate thousands', 'separate columns']);
    expect(open('100,5\n99,25')?.readings).toEqual(['are decimal', 'separate columns']);
    expect(rowsOf('z\n1,100\n1,090', 'separate thousands')).toEqual([['1100'], ['1090']]);
    expect(rowsOf('100,5\n99,25', 'are decimal')).toEqual([['100.5'], ['99.25']]);
    expect(rowsOf('0,10\n5,8', 'separate columns')).toEqual([
      ['0', '10'],
      ['5', '8'],
    ]);
    expect(open('0,0\n3.1,-12.2')).toBeNull();
  });
});
