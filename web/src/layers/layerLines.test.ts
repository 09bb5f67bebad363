import { expect, test } from 'vitest';
import { linesOf } from './layerLines';

test('lines become pairs of points; a name stands in the middle of its longest line', () => {
  const positions = new Float32Array([0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5, 9, 9, 9, 9, 8, 9]);
  const found = linesOf({
    header: { origin: [100, 200, 300], names: ['', 'Road'], kinds: ['point', 'line', 'polygon'] },
    arrays: { positions, starts: new Uint32Array([0, 3, 4]), names: new Uint32Array([1, 0, 1]), kinds: new Uint8Array([1, 0, 1]) },
  });
  expect([...found.segments]).toEqual([0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 9, 9, 9, 9, 8, 9]);
  expect([...found.points]).toEqual([5, 5, 5]);
  expect(found.names).toEqual([{ text: 'Road', at: [1, 0, 0] }]);
});
