import { expect, test } from 'vitest';
import { candidatesOf, suggestedRange } from './parameters';

test('a suggested range covers published values and the present one', () => {
  expect(suggestedRange([0.3, 0.5, 0.4], 0.2, { least: 0, most: 1 })).toEqual([0.2, 0.5]);
  expect(suggestedRange([], 0.2, { least: 0, most: 1 })).toEqual([0, 1]);
  expect(suggestedRange([], 12, { least: 0, leastExcluded: true })).toEqual([6, 24]);
  expect(suggestedRange([], 60, { least: 0, leastExcluded: true, most: 89 })).toEqual([30, 89]);
});

test('the numbers of materials that have an effect can be sought', () => {
  const project = { material: [{ name: 'Scree', roughness_deg: 5 }], analysis: { model: 'lumped_mass' } };
  const paths = candidatesOf(project, []).map(({ path }) => path);
  expect(paths).toContain('material.Scree.normal_restitution');
  expect(paths).toContain('material.Scree.roughness_deg');
  const pathOf = (name: string) => candidatesOf({ material: [{ name }] }, [])[0]!.path.replace(/\.\w+$/, '');
  expect(pathOf('Scree 1.5')).toBe('material."Scree 1.5"');
  expect(pathOf('the "old" fan')).toBe('material.0');
  expect(paths).not.toContain('material.Scree.rolling_friction');
});
