import { expect, test } from 'vitest';
import { asTyped, withTyped } from './lineEnds';

const typed = (text: string, from: string, to: string) => withTyped(text, asTyped(text).replace(from, to));

test('Windows line ends are kept, and new lines have them', () => {
  expect(typed('a = 1\r\nb = 2\r\n', 'b = 2', 'b = 3')).toBe('a = 1\r\nb = 3\r\n');
  expect(typed('a = 1\r\nb = 2\r\n', 'b = 2\n', 'b = 2\nc = 3\n# end')).toBe('a = 1\r\nb = 2\r\nc = 3\r\n# end');
  expect(typed('a = 1\r\n\r\nb = 2\r\n', '\n\n', '\n')).toBe('a = 1\r\nb = 2\r\n');
  expect(typed('a = 1\r\nb = 2', 'a = 1\nb = 2', '')).toBe('');
});

test('mixed line ends are kept in unchanged parts', () =>
  expect(typed('a\r\nb\nc\rd\r\n', 'b', 'B\n')).toBe('a\r\nB\r\n\nc\rd\r\n'));

test('other texts are unchanged', () => expect(typed('a\nb\n', 'a', 'c\n')).toBe('c\n\nb\n'));
