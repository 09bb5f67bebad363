import { expect, test } from 'vitest';
import { pathTitle } from './titles';

test('the numbers that a study varies have titles', () => {
  expect(pathTitle('material.Scree.tangential_restitution')).toBe('Scree: tangential restitution');
  expect(pathTitle('material.*.friction_angle_deg', 'deg')).toBe('All materials: friction angle');
  expect(pathTitle('material."Bed no. 2".roughness_deg@North', 'deg')).toBe('Bed no. 2: roughness, at North');
  expect(pathTitle('forest.Beech.drag_kg_s', 'kg/s')).toBe('Beech: drag');
  expect(pathTitle('analysis.normal_velocity_cutoff_m_s', 'm/s')).toBe('Normal velocity cutoff');
});
