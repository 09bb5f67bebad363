// What the run was given: settings, materials, seeders, barriers.

// As the project's settings are declared; a test holds this to it.
const onlyFor = {
  "lumped_mass": ["rotation", "sliding", "grazing_angle_deg", "friction_angle", "friction_angle_deg"],
  "rigid_sphere": ["tangential_crsp_damping", "roughness_spacing_m", "roughness_amplitude_m", "dynamic_friction", "rolling_friction"]
};
const of3dOnly = new Set(['maps_by_source', 'geopackage', 'section_m']);

// Whether a setting has any effect on a run.
function applies(run, group, key) {
  const given = run.project[group] || {};
  const {model} = run.project.analysis || {};
  if (Object.entries(onlyFor).some(([name, keys]) => model && name !== model && keys.includes(key))) return false;
  if (run.isSection && of3dOnly.has(key)) return false;
  if (key === 'rn_velocity_scale_m_s') return given.scale_rn_by_velocity !== false;
  if (key === 'rn_mass_scale_kg') return given.scale_rn_by_mass !== false;
  return key !== 'report';
}

function settings(parent) {
  const groups = ['analysis', 'sampling', 'design', 'output'];
  const keys = [...new Set(runs.flatMap((run) => groups.flatMap((group) =>
    Object.keys(run.project[group] || {}).filter((key) => applies(run, group, key)).map((key) => group + '/' + key))))];
  if (!keys.length) return element(parent, 'p', 'The summary does not hold the project.', {class: 'quiet'});
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

const without = (item, unwanted) => Object.fromEntries(Object.entries(item).filter(([key, value]) => !unwanted(key, value)));

function inputs(parent) {
  listTable(parent, 'Materials', (run) => materialsOf(run).map((m) => without(m, (key) => !applies(run, 'material', key))),
    (key, value) => property(value));
  listTable(parent, 'Seeders', (run) => seedersOf(run).map((s) => without(s, (key, value) => (key === 'line' && isNumber(value)) || value === false)),
    (key, value) => settingText(value));
  listTable(parent, 'Barriers and collectors', (run) => barriersOf(run).map(({name, collector, ...rest}) => {
    const kept = without(rest, (key, value) => key === 'source_line' || key === 'is_collector' || (key === 'line' && typeof value === 'string'));
    const row = {name, kind: collector ? 'collector' : 'barrier', ...kept};
    if (!collector && !isNumber(row.capacity_kJ)) row.capacity_kJ = 'unlimited';
    if (collector) delete row.capacity_kJ;
    return row;
  }), (key, value) => settingText(value));
}

function modelTables(parent) {
  const box = element(parent, 'div', null, {class: 'packed'});
  factsTable(box, 'Terrain', terrainRows);
  factsTable(box, 'Ground', groundRows);
  settings(box);
  inputs(parent);
}
