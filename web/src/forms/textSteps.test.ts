import { expect, test } from 'vitest';
import { endOfChange, stepOf } from './textSteps';

test('typing on one line without a pause is one step', () => {
  const first = stepOf('', 'a', 0);
  expect(stepOf('a', 'ab', 400)).toBe(first);
  const later = stepOf('ab', 'abc', 2000);
  expect(later).not.toBe(first);
  expect(stepOf('abc', 'abc\n', 2100)).not.toBe(later);
});

test('the end of a change', () => {
  expect(endOfChange('rocks = 77', 'rocks = 50')).toBe(10);
  expect(endOfChange('a # hello\nb', 'a\nb')).toBe(1);
  expect(endOfChange('aa', 'aaa')).toBe(3);
});
