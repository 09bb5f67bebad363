import { describe, expect, test } from 'vitest';
import type { LibraryMaterial } from '../api/types';
import { likeness } from './likeness';

const entry = (key: string, name: string, values: Record<string, unknown>): LibraryMaterial => ({ key, name, values, source: '', checked: '' });
const list = [
  entry('talus', 'Coarse talus', { normal_restitution: { mean: 0.3, distribution: 'normal', std_dev: 0.04 }, friction_angle_deg: 30 }),
  entry('rock', 'Bare rock', { normal_restitution: 0.5 }),
];
const changedOf = (material: Parameters<typeof likeness>[0]) => likeness(material, list);

describe('a material beside the library', () => {
  test('with its values and its name is as it is there', () => {
    expect(changedOf({ name: 'Coarse talus', like: 'talus' })).toMatchObject({ changed: [], hasItsName: true });
    expect(changedOf({ name: 'Coarse talus 2', like: 'talus' })).toMatchObject({ changed: [], hasItsName: true });
    expect(changedOf({ name: 'Coarse talus', like: 'talus', friction_angle_deg: 30 })?.changed).toEqual([]);
    expect(changedOf({ name: 'Bare rock', like: 'rock', normal_restitution: { mean: 0.5 } })?.changed).toEqual([]);
  });
  test('with another value has its name no more by right', () => {
    const found = changedOf({ name: 'Coarse talus', like: 'talus', normal_restitution: 0.6 });
    expect(found).toMatchObject({ changed: ['normal_restitution'], hasItsName: true });
    expect(changedOf({ name: 'Coarse talus', like: 'talus', roughness_deg: 5 })?.changed).toEqual(['roughness_deg']);
  });
  test('that takes the values of another one has none of those of its name', () => {
    const found = changedOf({ name: 'Coarse talus', like: 'rock' });
    expect(found?.of.key).toBe('talus');
    expect(found?.changed).toEqual(['normal_restitution', 'friction_angle_deg']);
    expect(changedOf({ name: 'Coarse talus' })?.changed).toEqual(['normal_restitution', 'friction_angle_deg']);
  });
  test('by a name of its own may have what values it likes', () => {
    expect(changedOf({ name: 'Gully', like: 'talus', friction_angle_deg: 35 })).toMatchObject({ changed: ['friction_angle_deg'], hasItsName: false });
    expect(changedOf({ name: 'Gully', normal_restitution: 0.4 })).toBeNull();
  });
});
