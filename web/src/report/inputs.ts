// The inputs of a run: settings, materials, seeders, barriers. Settings without an effect are left out, by the conditions
// of their declaration (settingEffects.ts).

import type { Setting, Settings } from '../archive/summary';
import type { Group } from '../figures/plot';
import { element } from './figure';
import { isList, property, settingText } from './format';
import { inputFiles, materialSources } from './inputSources';
import { listOf, type Run } from './run';
import { factsTable, listTable } from './runTables';
import { applies } from './settingEffects';
import { settingsTables } from './settingsTables';
import { groundRows, terrainRows } from './terrain';

// The entries of a table of the project, with the settings that have an effect.
const entriesOf = (run: Run, table: string): Settings[] =>
  listOf(run, table).map((entry) =>
    Object.fromEntries(Object.entries(entry).filter(([key]) => applies(run, table, key, entry))),
  );

const isGiven = (value: Setting) => value !== null && value !== undefined;

// The drag replaces the density, if it is given.
const forestOf = ({ name, density, drag_kg_s, height_m, polygon, values, ...rest }: Settings): Settings => ({
  name,
  density: isGiven(drag_kg_s) ? null : density,
  drag_kg_s,
  height_m,
  ...rest,
  ...(isList(polygon) && { polygon: `${polygon.length} corners` }),
  ...(isList(values) && { values: values.join(', ') }),
});

const withoutNo = (entry: Settings): Settings =>
  Object.fromEntries(Object.entries(entry).filter(([, value]) => value !== false));

function entries(parent: Group) {
  const plain = (_: string, value: Setting) => settingText(value);
  listTable(parent, 'Materials', (run) => entriesOf(run, 'material'), (_, value) => property(value));
  listTable(parent, 'Forests over the ground', (run) => entriesOf(run, 'forest').map(forestOf), plain);
  listTable(parent, 'Seeders', (run) => entriesOf(run, 'seeder').map(withoutNo), plain);
  const barriers = (run: Run, kind: string) => entriesOf(run, kind).map(({ name, ...rest }) => ({ name, kind, ...rest }));
  listTable(
    parent,
    'Barriers and collectors',
    (run) => [...barriers(run, 'barrier'), ...barriers(run, 'collector')],
    (_, value) => (value === 'inf' ? 'unlimited' : settingText(value)),
  );
}

export function modelTables(parent: Group) {
  const box = element(parent, 'div', null, { class: 'packed' });
  factsTable(box, 'Terrain', terrainRows);
  factsTable(box, 'Ground', groundRows);
  settingsTables(box);
  entries(parent);
  materialSources(parent);
  inputFiles(parent);
}
