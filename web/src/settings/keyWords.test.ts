import { expect, test } from 'vitest';
import { pathWords, unitOf, wordsOf } from './keyWords';

test('settings have words and units', () => {
  expect(wordsOf('normal_velocity_cutoff_m_s')).toBe('Normal velocity cutoff');
  expect(unitOf('normal_velocity_cutoff_m_s')).toBe('m/s');
  expect([wordsOf('model'), unitOf('model')]).toEqual(['Model', '']);
});

test('the numbers that a study varies have words', () => {
  expect(pathWords('material.Scree.tangential_restitution')).toBe('Tangential restitution, Scree');
  expect(pathWords('material.*.friction_angle_deg')).toBe('Friction angle, all materials');
  expect(pathWords('material.Bed no. 2.roughness_deg@North')).toBe('Roughness, Bed no. 2, at North');
  expect(pathWords('analysis.normal_velocity_cutoff_m_s')).toBe('Normal velocity cutoff');
});
