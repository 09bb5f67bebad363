import { expect, test } from 'vitest';
import { ownOf, withOwn } from './own';

test('settings of the view are kept by the name of the layer', () => {
  const kept = withOwn(withOwn('', 'Photo', { opacity: 0.5 }), 'Photo', { visible: false });
  expect(ownOf(kept)).toEqual({ Photo: { opacity: 0.5, visible: false } });
  expect(ownOf(withOwn(kept, 'Roads', { visible: true })).Photo).toEqual({ opacity: 0.5, visible: false });
  expect(ownOf('{')).toEqual({});
});
