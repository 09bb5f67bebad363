// How much energy rocks have along a section, how fast and how high they come.

const alongSection = ['energy_total', 'velocity', 'bounce_height', 'reach_share']
  .map((key) => figures.envelopeQuantities.find((quantity) => quantity.key === key));

const envelopeCellWidth = (run) => (run.project.output || {}).raster_cell_m || 1;

// With their edges, from the middles that the file has.
function envelopeCells(run) {
  const {columns, rows} = run.envelopes;
  const place = (name) => columns.indexOf(name);
  const half = envelopeCellWidth(run) / 2;
  const from = rows.map((row) => row[place('from_x_m')] - half), to = rows.map((row) => row[place('to_x_m')] + half);
  const values = columns.map((name, k) => [name, rows.map((row) => isNumber(row[k]) ? row[k] : null)]);
  return {name: run.label, colour: run.colour, x: from.map((x, k) => (x + to[k]) / 2), from, to,
    values: new Map(values.filter(([name]) => name !== 'from_x_m' && name !== 'to_x_m'))};
}

function envelopeFigure(parent, quantity) {
  const shown = runs.filter((run) => run.envelopes.rows.length && figures.curvesOf(run.envelopes.columns, quantity.key).length);
  if (!shown.length) return;
  const walls = shown.flatMap((run) => barriersOf(run).map((barrier) => ({name: barrier.name, x: (barrierLine(barrier)[0] || [])[0]})))
    .filter((wall, i, all) => isNumber(wall.x) && all.findIndex((w) => w.name === wall.name && w.x === wall.x) === i);
  const of = shown.map(envelopeCells);
  const title = quantity.key === 'reach_share' ? quantity.title : `${quantity.title} along the section`;
  figure(parent, {
    title, label: `${title}, in ${quantity.unit}`, caption: '', tall: 278,
    fill: (element, room) => figures.envelope(element, room, {...quantity, of, walls}),
    rows: () => figures.envelopeRows(of, quantity.key),
  });
}

function envelopeFigures(parent) {
  const box = element(parent, 'div', null, {class: 'columns'});
  for (const quantity of alongSection) envelopeFigure(box, quantity);
  const cellText = (run) => `${single ? '' : run.label + ': '}cells of ${metres(envelopeCellWidth(run))}` +
    (run.envelopes.cells_each > 1 ? `, drawn is the greatest of every ${number(run.envelopes.cells_each)}` : '');
  const cells = runs.filter((run) => run.envelopes.rows.length).map(cellText).join('; ');
  element(parent, 'p', `${startOfSentence(cells)}. Energies, velocities and heights are those of the rocks that come by.`, {class: 'quiet'});
}
