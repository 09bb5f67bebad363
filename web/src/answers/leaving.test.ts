import { expect, test } from 'vitest';
import { leaving } from './leaving';

test('rocks that end where the terrain has no data have left the model, too', () => {
  expect(leaving({ 'at rest': 4100, 'left the model': 17, 'no data': 883 }, 5000)).toEqual({
    share: '18 %',
    note: '900 of 5,000 rocks, 883 where the terrain has no data',
  });
  expect(leaving({ 'at rest': 4 }, 4)).toEqual({ share: '0 %', note: '0 of 4 rocks' });
  expect(leaving({}, 0)).toEqual({ share: '0 %', note: '0 of 0 rocks' });
});
