import { expect, test } from 'vitest';
import { edited } from '../toml/edit';
import { editOf } from './bestFit';

test('settings of the best set are edits of the text', () => {
  const text = '[[material]]\nname = "Scree" # steep\nroughness_deg = 5\n';
  const edits = ['material.0.roughness_deg={ mean = 7.5, std_dev = 1 }', 'material.0.friction_angle_deg=31.5'].map(editOf);
  expect(edited(text, edits)).toBe(
    '[[material]]\nname = "Scree" # steep\nroughness_deg = { mean = 7.5, std_dev = 1 }\nfriction_angle_deg = 31.5\n',
  );
});
