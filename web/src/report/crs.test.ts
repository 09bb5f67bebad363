import { expect, test } from 'vitest';
import { crsText } from './crs';

test('reads the name and the code of a coordinate system from both forms of its text', () => {
  const first = 'PROJCS["ETRS89 / UTM 32N",GEOGCS["ETRS89",AUTHORITY["EPSG","4258"]],AUTHORITY["EPSG","25832"]]';
  expect(crsText(first)).toBe('ETRS89 / UTM 32N (EPSG:25832)');
  expect(crsText('PROJCRS["MGI / Austria Lambert",BASEGEOGCRS["MGI"],ID["EPSG",31287]]')).toBe('MGI / Austria Lambert (EPSG:31287)');
  expect(crsText('ENGCRS["The ""quarry""",EDATUM["none"]]')).toBe('The "quarry"');
  expect(crsText('')).toBe('unnamed');
});
