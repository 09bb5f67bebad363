import { expect, test } from 'vitest';
import { cssText } from './cssText';

test('a text of CSS ends where it ends', () => {
  expect(cssText('a"\\\n<ü')).toBe('"a\\22 \\5c \\a \\3c ü"');
});
