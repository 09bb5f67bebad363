import { expect, test } from 'vitest';
import { valuesOf } from '../toml/values';
import { formOf, studyText, type StudyForm } from './study';

const form: StudyForm = {
  name: 'slope',
  observations: [
    { kind: 'stops', file: 'my "stops".csv', numbers: { accuracy_m: 2 } },
    { kind: 'values', file: 'hits.csv', at: 'Fence', numbers: { weight: 0.5 } },
    { kind: 'zones', file: 'deposits.gpkg', numbers: { weight: 0.5, released: 300, blocks: 40 } },
  ],
  parameters: [
    { path: 'material.Scree.roughness_deg', range: [1, 15] },
    { path: 'material.*.friction_angle_deg', range: [0, 0], prior: { mean: 30, distribution: 'normal', std_dev: 3 } },
  ],
  numbers: { draws: 100, seed: 7 },
};

test('a study is read as it was written', () => {
  const text = studyText(form, 'slope.toml');
  expect(formOf(valuesOf(text), 'slope', 'slope.toml')).toEqual({ ...form, written: 'slope.study.toml' });
  expect(valuesOf(text)).toMatchObject({ site: [{ project: 'slope.toml' }], draws: 100 });
});

test('a study that the panel cannot show whole is refused with the reason', () => {
  const read = (text: string) => () => formOf(valuesOf(text), 'slope', 'slope.toml');
  const site = '[[site]]\nproject = "slope.toml"\n';
  expect(read(site + site)).toThrow(/several sites/);
  expect(read('[[site]]\nproject = "other.toml"\n')).toThrow(/of the project "other.toml"/);
  expect(read(`hold_out_sites = true\n${site}`)).toThrow(/hold_out_sites/);
  expect(read(`${site}[[parameter]]\npath = "a"\neach_site = true\n`)).toThrow(/each_site/);
  expect(read(`${site}[[observations]]\nstops = "a.gpkg"\nlayer = "x"\n`)).toThrow(/layer/);
});
