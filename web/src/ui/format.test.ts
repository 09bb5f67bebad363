import { expect, test } from 'vitest';
import { counted } from './format';

test('one thing, or several', () => {
  expect(counted(1, 'rock')).toBe('1 rock');
  expect(counted(0, 'rock')).toBe('0 rocks');
  expect(counted(1234, 'rock')).toBe('1,234 rocks');
  expect(counted(2, 'vertex', 'vertices')).toBe('2 vertices');
});
