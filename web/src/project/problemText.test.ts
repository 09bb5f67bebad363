import { expect, test } from 'vitest';
import type { Problem } from '../api/types';
import { sentence, type Counting } from './problemText';

const problem = (what: string, why = '', hint = '') => ({ what, why, hint }) as Problem;
const counting = (kind?: Counting['kind']): Counting => ({ kind, columns: ['x', 'z'], rowAt: (row) => row });

test.each([
  ['rows', 'section[3][0] is "a"', 'section, row 4, x is "a"'],
  ['rows', 'section[3] is [3]', 'section, row 4 is [3]'],
  ['lists of rows', 'polylines[0][2][1] is "a"', 'polylines, polyline 1, row 3, z is "a"'],
  ['tuple', 'position[0] is "a"', 'position, x is "a"'],
  ['list', 'percentiles[2] is 101', 'percentiles, entry 3 is 101'],
  [undefined, 'height_m is -1', 'height_m is -1'],
] as const)('rows and columns are numbered as in the tables: %s', (kind, what, words) =>
  expect(sentence(problem(what), counting(kind))).toBe(words),
);

test('incomplete rows are counted', () =>
  expect(sentence(problem('section[3][0] is "a"'), { ...counting('rows'), rowAt: (row) => row + 2 })).toBe(
    'section, row 6, x is "a"',
  ));

test('a typed number that cannot be represented is not reported as a text', () => {
  const { what, why, hint } = { what: 'height_m is "1e999"', why: 'expected a number', hint: 'Leave out the quotes' };
  expect(sentence(problem(what, why, hint), counting())).toBe(
    'height_m is 1e999 (it is too large or too small to be represented; expected a number)',
  );
  expect(sentence(problem('height_m is "5"', why, hint), counting())).toBe(
    'height_m is "5" (expected a number). Leave out the quotes',
  );
});

test('the hint on a decimal comma does not mention quotes', () =>
  expect(sentence(problem('height_m is "97,5"', 'expected a number', 'Write 97.5, without quotes'), counting())).toBe(
    'height_m is "97,5" (expected a number). Write 97.5',
  ));
