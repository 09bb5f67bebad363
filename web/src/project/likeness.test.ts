import { describe, expect, test } from 'vitest';
import type { LibraryMaterial } from '../api/types';
import { isGivenName } from './libraryName';
import { likeness } from './likeness';

const entry = (key: string, name: string, values: Record<string, unknown>): LibraryMaterial => ({ key, name, values, sources: [] });
const list = [
  entry('talus', 'Coarse talus', { normal_restitution: { mean: 0.3, distribution: 'normal', std_dev: 0.04 }, friction_angle_deg: 30 }),
  entry('rock', 'Bare rock', { normal_restitution: 0.5 }),
];
const changedOf = (material: Parameters<typeof likeness>[0]) => likeness(material, list);

describe('a material compared with the library', () => {
  test('with the same name and values is unchanged', () => {
    expect(changedOf({ name: 'Coarse talus', like: 'talus' })).toMatchObject({ changed: [], isNamedLikeIt: true });
    expect(changedOf({ name: 'Coarse talus 2', like: 'talus' })).toMatchObject({ changed: [], isNamedLikeIt: true });
    expect(changedOf({ name: 'Coarse talus', like: 'talus', friction_angle_deg: 30 })?.changed).toEqual([]);
    expect(changedOf({ name: 'Bare rock', like: 'rock', normal_restitution: { mean: 0.5 } })?.changed).toEqual([]);
  });
  test('with another value is changed', () => {
    const found = changedOf({ name: 'Coarse talus', like: 'talus', normal_restitution: 0.6 });
    expect(found).toMatchObject({ changed: ['normal_restitution'], isNamedLikeIt: true });
    expect(changedOf({ name: 'Coarse talus', like: 'talus', roughness_deg: 5 })?.changed).toEqual(['roughness_deg']);
  });
  test('with the name of one entry and the values of another is compared by its name', () => {
    const found = changedOf({ name: 'Coarse talus', like: 'rock' });
    expect(found?.of.key).toBe('talus');
    expect(found?.changed).toEqual(['normal_restitution', 'friction_angle_deg']);
    expect(changedOf({ name: 'Coarse talus' })?.changed).toEqual(['normal_restitution', 'friction_angle_deg']);
  });
  test('with another name may have any values', () => {
    expect(changedOf({ name: 'Gully', like: 'talus', friction_angle_deg: 35 })).toMatchObject({ changed: ['friction_angle_deg'], isNamedLikeIt: false });
    expect(changedOf({ name: 'Gully', normal_restitution: 0.4 })).toBeNull();
  });
});

test('a name that the program gave can be replaced, one of the user cannot', () => {
  for (const name of ['Material 1', 'Material 12', 'Coarse talus', 'Bare rock 2', '', undefined]) expect(isGivenName(name, 'Material', list)).toBe(true);
  for (const name of ['Scree', 'Material of the road', 'Coarse talus above the road']) expect(isGivenName(name, 'Material', list)).toBe(false);
});
