import { expect, test } from 'vitest';
import { blocksText, drawnText, forestsOf, lawsOf, materialsOf, modelOf, originText } from './sheetInputs';
import { blockShape, releaseText } from './sheetReleases';

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
  expect(drawnText({ mean: '0.3', distribution: 'uniform', rel_min: '0.015', rel_max: '0.015' })).toBe('0.3, uniform, ±0.015');
  expect(drawnText({ mean: '0.8', distribution: 'lognormal', std_dev: '0.3', rel_min: '0.6', rel_max: '1.2' }, 'm')).toBe('0.8 m, lognormal, σ 0.3, −0.6/+1.2');
  expect(drawnText({ distribution: 'empirical', file: 'masses.csv' })).toBe('empirical, masses.csv');
});

test('rocks have their sizes', () => {
  expect(project('lumped_mass').seeder.map(blocksText)).toEqual(['mass 900 kg, lognormal, σ 500; 2,700 kg/m³', 'sizes of its table; 2,500 kg/m³']);
});

test('materials have the properties that the rock model uses', () => {
  expect(modelOf(project('rigid_sphere'))).toBe('rigid sphere');
  const of = (model: string) => materialsOf(project(model));
  const titles = (model: string) => of(model).columns.map(([, title]) => title);
  expect(titles('lumped_mass')).toEqual(['Rn', 'Rt', 'φ, °']);
  expect(of('lumped_mass').rows).toEqual([{ name: 'Scree', like: '', values: ['0.35, normal, σ 0.04', '0.85', '30'] }]);
  expect(titles('rigid_sphere')).toContain('μ rolling');
});

test('values of a material that are not of the library are named, defaults as such', () => {
  const { columns, rows } = materialsOf(project('lumped_mass'));
  const [rn] = rows[0]!.values;
  const row = { ...rows[0]!, like: 'talus_cover', values: [rn!, '0.8', '30'] };
  expect(originText(row, columns, new Set(['normal_restitution', 'tangential_restitution']), [1, 2])).toBe('as talus cover [1, 2]; φ default');
  expect(originText(row, columns, new Set(['normal_restitution']), [3])).toBe('as talus cover [3]; Rt own; φ default');
  expect(originText(row, columns, new Set(), [])).toBe('own values; φ default');
});

test('forests have their density or drag, and their height', () => {
  const forest = [
    { name: 'Spruce', density: 'medium', height_m: '18', polygons: 'stands.gpkg' },
    { name: 'Scrub', density: 'none', drag_kg_s: '120', height_m: '4' },
    { name: 'Gap', density: 'none' },
  ];
  expect(forestsOf({ forest })).toEqual(['Spruce: medium, 18 m high', 'Scrub: 120 kg/s, 4 m high', 'Gap: clearing']);
  expect(forestsOf({})).toEqual([]);
});

test('laws are those that have an effect', () => {
  const of = (model: string) => lawsOf({ analysis: { model, laws: 'talus', rotation: true, tangential_crsp_damping: true } });
  expect(of('lumped_mass')).toEqual(['laws talus', 'rotation yes']);
  expect(of('rigid_sphere')).toEqual(['laws talus', 'CRSP damping yes']);
});

test('shapes and releases in words', () => {
  const shapes = { analysis: { model: 'rigid_body' }, shape: [{ name: 'Slab', b_over_a: { mean: '0.8', distribution: 'none' }, c_over_b: '0.4', solid: 'none' }] };
  expect(blockShape(shapes, { shape: 'Slab' })).toBe('Slab (b/a 0.8; c/b 0.4)');
  expect(blockShape(shapes, { shape: 'long' })).toBe('long');
  expect(blockShape({ analysis: { model: 'lumped_mass' } }, { shape: 'sphere' })).toBe('none');
  expect(releaseText({ type: 'polygon', polygons: 'cliffs.geojson', min_slope_deg: '55', height_above_m: '2', horizontal_velocity_m_s: { mean: '0' } })).toBe(
    'in cells of cliffs.geojson, steeper than 55°, 2 m above the ground',
  );
  expect(releaseText({ type: 'point', position: ['4', '100'], horizontal_velocity_m_s: { mean: '1.5', distribution: 'none' } })).toBe('at (4, 100), 1.5 m/s');
});
