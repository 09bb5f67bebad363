// The inputs of a run: settings, materials, seeders, barriers. Settings without an effect are left out, by the conditions
// of their declaration (settingConditions, embedded from web/src/generated/schema.ts).

const applies = (run, table, key, row) =>
  figures.hasEffect((settingConditions[table] || {})[key] || [], table, row, run.project);

function settings(parent) {
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
    table(parent, {
      caption: wordsOf(group),
      head: [[{text: 'Setting'}, ...(single ? [{text: 'Value'}] : runs.map((run) => ({text: run.label, run})))]],
      rows: part.map((key) => [{text: wordsOf(key.split('/')[1]), unit: unitOf(key)}, ...runs.map((run) => valueOf(run, key))]),
      rowClass: (i) => differs(part[i]) ? 'differs' : '',
    });
  }
  if (keys.some(differs)) element(parent, 'p', 'Settings that differ are shaded.', {class: 'quiet'});
}

// The entries of a table of the project, with the settings that have an effect.
const entriesOf = (run, table) => listOf(run, table).map((entry) =>
  Object.fromEntries(Object.entries(entry).filter(([key]) => applies(run, table, key, entry))));

function inputs(parent) {
  listTable(parent, 'Materials', (run) => entriesOf(run, 'material'), (key, value) => property(value));
  listTable(parent, 'Seeders', (run) => entriesOf(run, 'seeder').map((seeder) =>
    Object.fromEntries(Object.entries(seeder).filter(([, value]) => value !== false))), (key, value) => settingText(value));
  const barriers = (run, kind) => entriesOf(run, kind).map(({name, ...rest}) => ({name, kind, ...rest}));
  listTable(parent, 'Barriers and collectors', (run) => [...barriers(run, 'barrier'), ...barriers(run, 'collector')],
    (key, value) => value === 'inf' ? 'unlimited' : settingText(value));
}

function modelTables(parent) {
  const box = element(parent, 'div', null, {class: 'packed'});
  factsTable(box, 'Terrain', terrainRows);
  factsTable(box, 'Ground', groundRows);
  settings(box);
  inputs(parent);
}
