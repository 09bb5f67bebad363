import { expect, test } from 'vitest';
import { decimalsOf, dividedText, shiftedText } from './texts';
import { fixedText } from './numbers';

test('changing the unit of a number keeps its digits', () => {
  expect(shiftedText('152530.42507165897', 3)).toBe('152.53042507165897');
  expect(shiftedText('-42', 3)).toBe('-0.042');
  expect(shiftedText('98000', 3)).toBe('98');
  expect(shiftedText('0', 3)).toBe('0');
  expect(shiftedText('0.5', 6)).toBe('0.0000005');
  expect(shiftedText('1.25e+09', 3)).toBe('1.25e6');
  expect(shiftedText('3.4', 0)).toBe('3.4');
  expect(shiftedText('unlimited', 3)).toBe('unlimited');
});

test('a column has enough decimals to distinguish its values', () => {
  expect(decimalsOf([0.5, 12.25, 19.875])).toBe(3);
  expect(decimalsOf([2667891.2345, 2668591.9])).toBe(2); // 700 m apart
  expect(decimalsOf([0, 152530.42507165897])).toBe(0);
  expect(decimalsOf([1, 2, 3])).toBe(0);
  expect(decimalsOf([0.25, 0.25])).toBe(4);
  expect(decimalsOf([])).toBe(0);
  expect(fixedText(2667891.2345, 2)).toBe('2,667,891.23');
  expect(fixedText(3, 2)).toBe('3.00');
  expect(fixedText(-1e-17, 2)).toBe('0.00');
});

test('division of a number text', () => {
  expect(dividedText('152530.42507165897', 1000)).toBe('152.53042507165897');
  expect(dividedText('0.3048', 0.3048)).toBe('1');
  expect(dividedText('', 0.3048)).toBe('');
  expect(dividedText('unlimited', 0.3048)).toBe('unlimited');
});
