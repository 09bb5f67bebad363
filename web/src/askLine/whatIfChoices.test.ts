import { expect, test } from 'vitest';
import { optionsOf } from './whatIfChoices';

const choices = {
  materials: ['Scree', 'Rock'],
  factors: [
    { factor: 'normal_restitution', title: 'Normal restitution', usual_percent: 10 },
    { factor: 'mass', title: 'Rock mass', usual_percent: 25 },
  ],
};

test('the usual steps are left to the engine', () => {
  expect(optionsOf(choices, {}, '')).toEqual({});
  expect(optionsOf(choices, {}, 'Scree')).toEqual({ material: 'Scree' });
});

test('inputs are left out, and steps typed', () => {
  expect(optionsOf(choices, { mass: false }, '')).toEqual({ steps: { normal_restitution: 10 } });
  expect(optionsOf(choices, { normal_restitution: '12,5' }, '')).toEqual({ steps: { normal_restitution: 12.5, mass: 25 } });
  expect(optionsOf(choices, { mass: false, normal_restitution: false }, '')).toBeNull();
});

test('what is not a number goes to the engine, which says so', () => {
  expect(optionsOf(choices, { mass: 'much' }, '')).toEqual({ steps: { normal_restitution: 10, mass: 'much' } });
  expect(optionsOf(choices, { mass: ' ' }, '')).toEqual({ steps: { normal_restitution: 10, mass: '' } });
});

test('a choice for a factor that this run does not have is not sent', () => {
  expect(optionsOf(choices, { forest_drag: '30' }, '')).toEqual({});
});
