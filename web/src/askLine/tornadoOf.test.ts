import { expect, test } from 'vitest';
import type { Variation, WhatIfAnswer } from '../api/whatIf';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import { barsOf, changeText, editsOf, figureTitle, nameOf } from './tornadoOf';

const variation = (factor: string, step: number, share: number, energy: number | null): Variation => ({
  factor,
  title: factor,
  step_percent: step,
  text: '',
  clipped: '',
  changes: [],
  rocks: 10,
  share: [0.1, 0.08, 0.12],
  energy_J: null,
  ke_translational_J: null,
  ke_total_J: null,
  height_m: null,
  velocity_m_s: null,
  difference: {
    gained: 1,
    lost: 0,
    share: [share, share - 0.01, share + 0.01],
    energy_J: energy === null ? null : [energy, null, null],
    height_m: null,
    velocity_m_s: null,
  },
});

const answer: WhatIfAnswer = {
  rocks: 100,
  planned: 100,
  percentile: 95,
  confidence: 0.95,
  energy: 'translational',
  model: 'lumped_mass',
  base: { rocks: 10, share: [0.1, 0.08, 0.12], energy_J: null, ke_translational_J: null, ke_total_J: null, height_m: null, velocity_m_s: null },
  variations: [variation('friction', -10, 0.02, 500), variation('friction', 10, -0.03, -2000), variation('mass', -25, 0, null), variation('mass', 25, 0.05, 90_000)],
};

const percent = { unit: '%', per: 0.01 };
const kilojoules = { unit: 'kJ', per: 1000 };

test('a row for each factor, the largest change on top, both steps in it', () => {
  const bars = barsOf(answer, 'share', percent);
  expect(bars.map(({ name, other }) => [name, other?.name])).toEqual([
    ['mass −25 %', 'mass +25 %'],
    ['friction −10 %', 'friction +10 %'],
  ]);
  expect(bars.map(({ row }) => row)).toEqual(['mass', 'friction']);
  expect(bars[1]!.value).toBeCloseTo(2);
  expect(bars[1]!.other!.low).toBeCloseTo(-4);
});

test('a step after which no rock crosses has no bar', () => {
  expect(barsOf(answer, 'energy_J', kilojoules).map(({ name, other }) => [name, other?.name])).toEqual([
    ['mass +25 %', undefined],
    ['friction −10 %', 'friction +10 %'],
  ]);
  expect(changeText(null, kilojoules)).toBe('no rock crosses');
});

test('other rock models are rows of their own', () => {
  const model = { ...variation('model', 0, 0.1, null), title: 'Rock model', step_percent: null, model: 'rigid_sphere' };
  const bars = barsOf({ ...answer, variations: [model, ...answer.variations] }, 'share', percent);
  expect([bars[0]!.name, bars[0]!.other]).toEqual(['Rock model: rigid sphere', undefined]);
});

test('changes are written with their sign and interval', () => {
  expect(changeText([0.042, 0.036, 0.048], percent)).toBe('+4.2 (+3.6 to +4.8) %');
  expect(changeText([-2000, null, null], kilojoules)).toBe('−2 kJ');
  expect(nameOf(answer.variations[0]!)).toBe('friction −10 %');
});

test('the energy of a figure has its name', () => {
  expect(figureTitle('energy_J', answer)).toBe('95 % translational energy');
  expect(figureTitle('height_m', answer)).toBe('95 % height');
});

test('a change is an edit of the text', () => {
  const text = '[[material]]\nname = "Wood"\nforest = "medium" # oaks\nnormal_restitution = { mean = 0.3, distribution = "normal", std_dev = 0.04 }\n';
  const after = edited(
    text,
    editsOf([
      { path: ['material', 0, 'forest'], name: 'Wood', before: 'medium', after: null },
      { path: ['material', 0, 'forest_drag_kg_s'], name: 'Wood', before: null, after: 625 },
      { path: ['material', 0, 'normal_restitution'], name: 'Wood', before: {}, after: { mean: 0.33, distribution: 'normal', std_dev: 0.04 } },
    ]),
  );
  expect(valuesOf(after).material).toEqual([
    { name: 'Wood', forest_drag_kg_s: 625, normal_restitution: { mean: 0.33, distribution: 'normal', std_dev: 0.04 } },
  ]);
});

test('another rock model is an edit of a table that is not repeated', () => {
  const model = (text: string) => valuesOf(edited(text, editsOf([{ path: ['analysis', 0, 'model'], name: '', before: 'lumped_mass', after: 'rigid_sphere' }])));
  expect(model('name = "A"\n')).toEqual({ name: 'A', analysis: { model: 'rigid_sphere' } });
  expect(model('[analysis]\nrotation = false\n')).toEqual({ analysis: { rotation: false, model: 'rigid_sphere' } });
});
