import { expect, test } from 'vitest';
import { shortened } from './tornado';

test('a long name keeps its end, which tells settings of one table apart', () => {
  expect(shortened('runout', 64)).toBe('runout');
  expect(shortened('material.Scree.normal_restitution', 128)).toBe('….normal_restitution');
  expect(shortened('material.Scree.normal_restitution', 128)).toHaveLength(20);
});
