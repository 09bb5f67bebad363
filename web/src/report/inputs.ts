// The inputs of a run: settings, materials, seeders, barriers. Settings without an effect are left out, by the conditions
// of their declaration (settings.js).

import { element } from './figure';
import { number, property, settingText, unitOf, wordsOf } from './format';
import { listOf, runs, single } from './run';
import { factsTable, forEachRun, listTable } from './runTables';
import { applies, defaultText } from './settingEffects';
import { table } from './tables';
import { groundRows, terrainRows } from './terrain';

export function settings(parent) {
  const groups = ['analysis', 'sampling', 'design', 'output'];
  const shown = (run, group, key) => applies(run, group, key, run.project[group]) && key !== 'report';
  const keys = [...new Set(runs.flatMap((run) => groups.flatMap((group) =>
    Object.keys(run.project[group] || {}).filter((key) => shown(run, group, key)).map((key) => group + '/' + key))))];
  if (!keys.length) return element(parent, 'p', 'The summary does not contain the project.', {class: 'quiet'});
  const valueOf = (run, key) => {
    const [group, name] = key.split('/');
    return run.project[group] ? settingText(run.project[group][name]) : '–';
  };
  const differs = (key) => !single && valueOf(runs[0], key) !== valueOf(runs[1], key);
  for (const group of groups) {
    const part = keys.filter((key) => key.startsWith(group + '/'));
    if (!part.length) continue;
    // A third column with the default of settings that have another value, unless all have their defaults.
    const changed = (key) => runs.some((run) => defaultText(key) !== null && valueOf(run, key) !== '–' && valueOf(run, key) !== defaultText(key));
    const hasDefaults = part.some(changed);
    table(parent, {
      caption: wordsOf(group),
      head: [[{text: 'Setting'}, ...(single ? [{text: 'Value'}] : runs.map((run) => ({text: run.label, run}))), ...(hasDefaults ? [{text: 'Default'}] : [])]],
      rows: part.map((key) => [{text: wordsOf(key.split('/')[1]), unit: unitOf(key)}, ...runs.map((run) => valueOf(run, key)), ...(hasDefaults ? [changed(key) ? defaultText(key) : ''] : [])]),
      rowClass: (i) => differs(part[i]) ? 'differs' : '',
    });
  }
  if (keys.some(differs)) element(parent, 'p', 'Settings that differ are shaded.', {class: 'quiet'});
}

// The entries of a table of the project, with the settings that have an effect.
const entriesOf = (run, table) => listOf(run, table).map((entry) =>
  Object.fromEntries(Object.entries(entry).filter(([key]) => applies(run, table, key, entry))));

export function inputs(parent) {
  listTable(parent, 'Materials', (run) => entriesOf(run, 'material'), (key, value) => property(value));
  const isGiven = (value) => value !== null && value !== undefined;
  const forest = ({name, density, drag_kg_s, height_m, polygon, values, ...rest}) => ({
    name, density: isGiven(drag_kg_s) ? null : density, drag_kg_s, height_m, ...rest,
    ...(polygon && {polygon: `${polygon.length} corners`}), ...(values && {values: values.join(', ')}),
  });
  listTable(parent, 'Forests over the ground', (run) => entriesOf(run, 'forest').map(forest), (key, value) => settingText(value));
  listTable(parent, 'Seeders', (run) => entriesOf(run, 'seeder').map((seeder) =>
    Object.fromEntries(Object.entries(seeder).filter(([, value]) => value !== false))), (key, value) => settingText(value));
  const barriers = (run, kind) => entriesOf(run, kind).map(({name, ...rest}) => ({name, kind, ...rest}));
  listTable(parent, 'Barriers and collectors', (run) => [...barriers(run, 'barrier'), ...barriers(run, 'collector')],
    (key, value) => value === 'inf' ? 'unlimited' : settingText(value));
}

const wordsOfKeys = (keys) => keys.map((key) => wordsOf(key).toLowerCase()).join(', ');

// Sources of materials' values that are those of the library.
function materialSources(parent) {
  forEachRun('Sources of the materials’ values', (run) => (run.summary.inputs || {}).material_sources || [], (title, list) => table(parent, {
    caption: title, head: [['Material', 'Library', 'Values', 'Source']],
    rows: list.map(({material, like, keys, source}) => [material, like, wordsOfKeys(keys), source]),
  }));
}

function inputFiles(parent) {
  forEachRun('Input files', (run) => (run.summary.inputs || {}).files || [], (title, list) => table(parent, {
    caption: title, head: [['File', {text: 'Size', unit: 'bytes'}, 'SHA-256']],
    rows: list.map(({name, bytes, sha256}) => [name, number(bytes, 15), {text: '', draw: (td) => element(td, 'code', sha256 || '–', {class: 'sum'})}]),
    numeric: (column) => column === 1,
  }));
  if (runs.some((run) => run.summary.inputs)) {
    element(parent, 'p', 'Files as they were when the run began; paths are relative to the project file. sha256sum FILE, or Get-FileHash FILE on Windows, prints the checksum of a file.', {class: 'quiet'});
  }
}

export function modelTables(parent) {
  const box = element(parent, 'div', null, {class: 'packed'});
  factsTable(box, 'Terrain', terrainRows);
  factsTable(box, 'Ground', groundRows);
  settings(box);
  inputs(parent);
  materialSources(parent);
  inputFiles(parent);
}
