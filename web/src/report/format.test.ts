import { expect, test } from 'vitest';
import { rockModels, rockModelTitle } from '../figures/rockModels';
import { schema } from '../generated/schema';
import { settingText } from './format';

test('every rock model has a name, which reports write wherever they mention it', () => {
  const models = schema.properties.analysis.properties.model.enum;
  expect(Object.keys(rockModels).sort()).toEqual([...models].sort());
  expect(models.map((model) => settingText(model))).toEqual(['lumped mass', 'rigid sphere', 'rigid body']);
  expect(models.map(rockModelTitle)).toEqual(['Lumped mass', 'Rigid sphere', 'Rigid body']);
});
