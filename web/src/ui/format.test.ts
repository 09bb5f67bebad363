import { expect, test } from 'vitest';
import { counted, shiftedText } from './format';

test('one thing, or several', () => {
  expect(counted(1, 'rock')).toBe('1 rock');
  expect(counted(0, 'rock')).toBe('0 rocks');
  expect(counted(1234, 'rock')).toBe('1,234 rocks');
  expect(counted(2, 'vertex', 'vertices')).toBe('2 vertices');
});

test('a number of a file in another unit has the same digits', () => {
  expect(shiftedText('152530.42507165897', 3)).toBe('152.53042507165897');
  expect(shiftedText('-42', 3)).toBe('-0.042');
  expect(shiftedText('98000', 3)).toBe('98');
  expect(shiftedText('0', 3)).toBe('0');
  expect(shiftedText('0.5', 6)).toBe('0.0000005');
  expect(shiftedText('1.25e+09', 3)).toBe('1.25e6');
  expect(shiftedText('3.4', 0)).toBe('3.4');
  expect(shiftedText('unlimited', 3)).toBe('unlimited');
});
