import { expect, test } from 'vitest';
import { drawnText, materialsOf, modelOf, rocksOf } from './sheetInputs';

const material = {
  name: 'Scree',
  normal_restitution: { mean: '0.35', distribution: 'normal', std_dev: '0.04' },
  tangential_restitution: { mean: '0.85', distribution: 'none' },
  friction_angle_deg: { mean: '30' },
  rolling_friction: { mean: '0.4' },
};
const project = (model: string) => ({
  analysis: { model },
  material: [material],
  seeder: [
    { name: 'Crest', mass_kg: { mean: '900', distribution: 'lognormal', std_dev: '500' }, density_kg_m3: { mean: '2700' } },
    { name: 'Survey', type: 'table', density_kg_m3: { mean: '2500' } },
  ],
});

test('distributions are named with their spread', () => {
  expect(drawnText('1250.5')).toBe('1,251');
  expect(drawnText({ mean: '900', distribution: 'none' })).toBe('900');
  expect(drawnText({ mean: '900', distribution: 'lognormal', std_dev: '500' })).toBe('900, lognormal, σ 500');
  expect(drawnText({ distribution: 'empirical', file: 'masses.csv' })).toBe('empirical, masses.csv');
});

test('rocks have their sizes', () => {
  expect(rocksOf(project('lumped_mass'))).toEqual(['Crest: mass 900 kg, lognormal, σ 500; 2,700 kg/m³', 'Survey: sizes of its table; 2,500 kg/m³']);
});

test('materials have the properties that the rock model uses', () => {
  expect(modelOf(project('rigid_sphere'))).toBe('rigid sphere');
  const of = (model: string) => materialsOf(project(model));
  expect(of('lumped_mass')).toEqual({ columns: ['Rn', 'Rt', 'φ, °'], rows: [{ name: 'Scree', values: ['0.35, normal, σ 0.04', '0.85', '30'] }] });
  expect(of('rigid_sphere').columns).toContain('μ rolling');
});
