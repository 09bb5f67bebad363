// Energy, velocity and bounce height of the rocks along a section.

import * as figures from '../figures/report';
import { element, figure } from './figure';
import { amountIn, displayOf, isNumber, lengthText, number, unitIn } from './format';
import { barrierLine, barriersOf, runs, single, startOfSentence } from './run';

const alongSection = ['energy_total', 'velocity', 'bounce_height', 'reach_share']
  .map((key) => figures.envelopeQuantities.find((quantity) => quantity.key === key));

const envelopeCellWidth = (run) => (run.project.output || {}).raster_cell_m || 1;

// Cells with their edges; the file has their centres.
function envelopeCells(run) {
  const {columns, rows} = run.envelopes;
  const index = (name) => columns.indexOf(name);
  const half = envelopeCellWidth(run) / 2;
  const from = rows.map((row) => row[index('from_x_m')] - half), to = rows.map((row) => row[index('to_x_m')] + half);
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
  const {unit, per} = displayOf(quantity.unit);
  const along = (xs) => xs.map((x) => amountIn('m', x));
  const title = `${quantity.title} along the section`;
  figure(parent, {
    title, label: `${title}, in ${unit}`, caption: '', tall: 278,
    fill: (element, room) => figures.envelope(element, room, {
      ...quantity, unit, per: quantity.per * per, xUnit: unitIn('m'),
      of: of.map((cells) => ({...cells, x: along(cells.x), from: along(cells.from), to: along(cells.to)})),
      walls: walls.map((wall) => ({...wall, x: amountIn('m', wall.x)})),
    }),
    rows: () => figures.envelopeRows(of, quantity.key),
  });
}

export function envelopeFigures(parent) {
  const box = element(parent, 'div', null, {class: 'columns'});
  for (const quantity of alongSection) envelopeFigure(box, quantity);
  const cellText = (run) => `${single ? '' : run.label + ': '}cells of ${lengthText(envelopeCellWidth(run))}` +
    (run.envelopes.cells_each > 1 ? `, drawn as the maximum of every ${number(run.envelopes.cells_each)} cells` : '');
  const cells = runs.filter((run) => run.envelopes.rows.length).map(cellText).join('; ');
  element(parent, 'p', `${startOfSentence(cells)}. Energies, velocities and heights are those of the rocks that pass.`, {class: 'quiet'});
}
