// The runs of the page, from its embedded data. Table rows become objects keyed by column name.

import { energyText, isNumber, lengthText, measured, showIn } from './format';

export const page = JSON.parse(document.getElementById('data').textContent);

const records = (table) => table.rows.map((row) => Object.fromEntries(table.columns.map((name, i) => [name, row[i]])));

export const runs = page.runs.map((data, index) => {
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
    stops: data.observed ? records(data.observed.stops) : [],
    hits: records(data.hits),
    hitTotal: data.hits.total,
    losses: records(data.losses),
    lossTotal: data.losses.of_shown_paths,
    lossByNumber: records({columns: data.losses.by_number_columns, rows: data.losses.by_number}),
    rocks: data.paths.rocks.map((rock) => ({rock: rock.rock, run: index, rows: records({columns: data.paths.columns, rows: rock.rows})})),
    rocksWithPaths: data.paths.total,
  };
});
// Two runs with the same name are labelled by their folders, or else by their order.
export const single = runs.length === 1;
export const alike = !single && runs[0].name === runs[1].name;
for (const run of runs) {
  const folder = alike && runs[0].folder !== runs[1].folder ? run.folder : `${run.name}, run ${run.index + 1}`;
  run.label = alike ? folder : run.name;
}

// x and y of a terrain are coordinates on a map, in metres always; its heights and all of a section are lengths.
export const xyText = (run, value) => run.isSection ? lengthText(value) : `${measured(value, 5)} m`;
export const placeText = (run, {x, y, z}, hasY = !run.isSection) => [`x ${xyText(run, x)}`, ...(hasY ? [`y ${xyText(run, y)}`] : []), ...(isNumber(z) ? [`z ${lengthText(z)}`] : [])].join(', ');

export const metricParts = runs.every((run) => run.isSection) ? 'Inputs' : 'Coordinates x and y, inputs';

// The title block; of two runs that of the first. Both papers leave columns of 184 mm between their margins.
export const titleBlock = runs[0].project.report || {};
if (titleBlock.units === 'us') showIn('US customary');
export const papers = {A4: {size: 'A4 portrait', mm: 184}, A3: {size: 'A3 landscape', mm: 394}};
export const paperName = papers[titleBlock.paper] ? titleBlock.paper : 'A4';

// The entries of a repeated table of the project, such as [[material]].
export const listOf = (run, table) => run.project[table] || [];
export const materialsOf = (run) => listOf(run, 'material');
export const barriersOf = (run) => [...listOf(run, 'barrier'), ...listOf(run, 'collector')];

// Capitalizes a sentence. With two runs it begins with a run's name, which stays as it is.
export const startOfSentence = (text) => single ? text.charAt(0).toUpperCase() + text.slice(1) : text;

// A barrier's line on plan as points. In 2D it may be a single x.
export function barrierLine(barrier) {
  const line = barrier.line;
  if (isNumber(line)) return [[line, 0]];
  if (!Array.isArray(line) || !line.length) return [];
  return Array.isArray(line[0]) ? line : [[line[0], line[1] || 0]];
}

export const endText = (run) => (end) => [`End of rock ${end.rock}` + (single ? '' : ` · ${run.label}`), end.end_reason,
  placeText(run, end),
  `runout ${lengthText(end.runout_xy)}, time ${measured(end.time)} s`,
  `maximum total kinetic energy ${energyText(end.max_ke)}`].join('\n');
