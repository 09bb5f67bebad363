// The runs of the page, read from its data: what the files said, with names instead of places in a row.

const page = JSON.parse(document.getElementById('data').textContent);

// Rows of a table as objects.
const records = (table) => table.rows.map((row) => Object.fromEntries(table.columns.map((name, i) => [name, row[i]])));

const runs = page.runs.map((data, index) => {
  const summary = data.summary;
  const project = summary.project || {};
  const name = summary.name || project.name || data.folder;
  return {
    ...data, index, name, project,
    colour: index === 0 ? 'var(--run-a)' : 'var(--run-b)',
    terrain: summary.terrain || {},
    isSection: (summary.terrain || {}).kind === 'section',
    statistics: summary.statistics || {},
    histograms: summary.histograms || {},
    barriers: summary.barriers || [],
    warnings: summary.warnings || [],
    endpoints: records(data.endpoints),
    endpointTotal: data.endpoints.total,
    hits: records(data.hits),
    hitTotal: data.hits.total,
    losses: records(data.losses),
    lossTotal: data.losses.of_shown_paths,
    lossByNumber: records({columns: data.losses.by_number_columns, rows: data.losses.by_number}),
    rocks: data.paths.rocks.map((rock) => ({rock: rock.rock, run: index, rows: records({columns: data.paths.columns, rows: rock.rows})})),
    rocksWithPaths: data.paths.total,
  };
});
// Two runs of one name are told apart by their folders, or else by their order.
const single = runs.length === 1;
const alike = !single && runs[0].name === runs[1].name;
for (const run of runs) {
  const folder = alike && runs[0].folder !== runs[1].folder ? run.folder : `${run.name}, run ${run.index + 1}`;
  run.label = alike ? folder : run.name;
}

// Lists that the project's file has as [[material]] may be echoed under the one name or under the many.
function listOf(run, one, many) {
  const list = run.project[many] ?? run.project[one];
  return Array.isArray(list) ? list.filter((item) => item && typeof item === 'object') : [];
}
const materialsOf = (run) => listOf(run, 'material', 'materials');
const seedersOf = (run) => listOf(run, 'seeder', 'seeders');
function barriersOf(run) {
  const barriers = listOf(run, 'barrier', 'barriers').map((b) => ({...b, collector: b.is_collector === true || b.kind === 'collector'}));
  const collectors = listOf(run, 'collector', 'collectors').map((b) => ({...b, collector: true}));
  return [...barriers, ...collectors];
}
