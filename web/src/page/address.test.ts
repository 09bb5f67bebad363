import { expect, test } from 'vitest';
import { addressOf, isStep, placeOf, type Place } from './address';

const start: Place = {
  file: null,
  verifying: false,
  chosen: null,
  sidePanel: 'model',
  resultsTab: 'overview',
  run: null,
  compared: null,
  rock: null,
  map: null,
  asked: null,
  camera: null,
};
const slope: Place = { ...start, file: 'a folder/Böschung #1?.toml' };
const whole: Place = {
  ...slope,
  chosen: ['seeder', 0],
  sidePanel: 'runs',
  resultsTab: 'maps',
  run: '20261124-183139-001',
  compared: '20261124-170000-000',
  rock: 12,
  map: 'energy & more=%',
  asked: 'barrier~A net & more',
  camera: '1756000,5917000,200,1756100.5,5917100.25,150',
};

test('every place has its address', () => {
  for (const place of [start, { ...start, verifying: true }, slope, { ...slope, asked: '' }, { ...slope, asked: 'line~15,0.5~15,-50' }, whole])
    expect(placeOf(addressOf(place), { sidePanel: 'text', resultsTab: 'rock' })).toEqual(
      place.file === null ? { ...place, sidePanel: 'text', resultsTab: 'rock' } : place,
    );
});

test('an address can be read by people', () => {
  expect(addressOf(start)).toBe('');
  expect(addressOf({ ...whole, file: 'sites/slope.toml', map: 'energy_p95', asked: 'line~15,0~15,50' })).toBe(
    '#/sites/slope.toml?panel=runs&form=seeder.0&tab=maps&run=20261124-183139-001&with=20261124-170000-000&rock=12&map=energy_p95&ask=line~15,0~15,50&view=1756000,5917000,200,1756100.5,5917100.25,150',
  );
});

test('what cannot be read is left out', () => {
  const now = { sidePanel: 'runs', resultsTab: 'rock' } as const;
  expect(placeOf('#/a.toml', now)).toEqual({ ...start, ...now, file: 'a.toml' });
  expect(placeOf('#/a.toml?panel=nowhere&tab=&rock=-1&run=%E0%A4%A', now)).toEqual({ ...start, ...now, file: 'a.toml' });
  for (const address of ['#', '#/', '#/%E0', '#results', '#/?tab=rock'])
    expect(placeOf(address, now)).toEqual({ ...start, ...now });
});

test('the first run to be shown and the view are no steps', () => {
  expect(isStep(slope, { ...slope, run: 'a', rock: 1, map: 'm', camera: 'plan' })).toBe(false);
  expect(isStep({ ...slope, rock: 1 }, slope)).toBe(false);
  expect(isStep({ ...slope, asked: 'line~1,2~3,4' }, { ...slope, asked: 'line~1,2~3,5' })).toBe(false);
  for (const change of [{ run: 'b' }, { compared: 'b' }, { rock: 2 }, { map: 'n' }, { resultsTab: 'rock' }, { asked: '' }, { file: 'b.toml' }] as const)
    expect(isStep({ ...slope, run: 'a', compared: 'a', rock: 1, map: 'm' }, { ...slope, run: 'a', compared: 'a', rock: 1, map: 'm', ...change })).toBe(true);
  expect(isStep(start, { ...start, resultsTab: 'rock' })).toBe(false);
  expect(isStep(start, { ...start, verifying: true })).toBe(true);
});
