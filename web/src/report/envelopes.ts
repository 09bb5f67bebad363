// Energy, velocity and bounce height of the rocks along a section.

import { curvesOf, envelope, envelopeQuantities, envelopeRows, type Cells, type EnvelopeQuantity } from '../figures/envelope';
import type { Group } from '../figures/plot';
import { element, figure } from './figure';
import { amountIn, displayOf, isNumber, lengthText, number, unitIn } from './format';
import { barrierLine, barriersOf, nameIn, runs, single, startOfSentence, tableOf, type Run } from './run';

const shownKeys = ['energy_total', 'velocity', 'bounce_height', 'reach_share'];
const alongSection = shownKeys.flatMap((key) => envelopeQuantities.find((quantity) => quantity.key === key) ?? []);

function cellWidth(run: Run): number {
  const { raster_cell_m } = tableOf(run, 'output');
  return isNumber(raster_cell_m) ? raster_cell_m : 1;
}

// Cells with their edges; the data have the centres of the first and the last cell that each of them joins.
function cellsOf(run: Run): Cells {
  const { columns, rows } = run.envelopes;
  const values = new Map(columns.map((name, k) => [name, rows.map((row) => row[k] ?? null)]));
  const half = cellWidth(run) / 2;
  const from = (values.get('from_x_m') ?? []).map((x) => Number(x) - half);
  const to = (values.get('to_x_m') ?? []).map((x) => Number(x) + half);
  values.delete('from_x_m');
  values.delete('to_x_m');
  return { name: run.label, colour: run.colour, x: from.map((x, k) => (x + to[k]!) / 2), from, to, values };
}

// Barriers of all runs, once each.
function wallsOf(shown: readonly Run[]) {
  const walls = shown.flatMap((run) =>
    barriersOf(run).flatMap((barrier) => {
      const [x] = barrierLine(barrier)[0] ?? [];
      return isNumber(x) ? [{ name: nameIn(barrier), x }] : [];
    }),
  );
  return walls.filter((wall, k) => walls.findIndex(({ name, x }) => name === wall.name && x === wall.x) === k);
}

const inUnit = (xs: readonly number[]) => xs.map((x) => amountIn('m', x));

function envelopeFigure(parent: Group, quantity: EnvelopeQuantity) {
  const shown = runs.filter(
    ({ envelopes: { rows, columns } }) => rows.length > 0 && curvesOf(columns, quantity.key).length > 0,
  );
  if (shown.length === 0) return;
  const of = shown.map(cellsOf);
  const walls = wallsOf(shown);
  const { unit, per } = displayOf(quantity.unit);
  const title = `${quantity.title} along the section`;
  figure(parent, {
    title,
    label: `${title}, in ${unit}`,
    caption: '',
    tall: 278,
    fill: (svg, room) =>
      envelope(svg, room, {
        ...quantity,
        unit,
        per: quantity.per * per,
        xUnit: unitIn('m'),
        of: of.map((cells) => ({ ...cells, x: inUnit(cells.x), from: inUnit(cells.from), to: inUnit(cells.to) })),
        walls: walls.map(({ name, x }) => ({ name, x: amountIn('m', x) })),
      }),
    rows: () => envelopeRows(of, quantity.key),
  });
}

function cellText(run: Run): string {
  const { cells_each } = run.envelopes;
  const joined = cells_each > 1 ? `, drawn as the maximum of every ${number(cells_each)} cells` : '';
  return `${single ? '' : `${run.label}: `}cells of ${lengthText(cellWidth(run))}${joined}`;
}

export function envelopeFigures(parent: Group) {
  const box = element(parent, 'div', null, { class: 'columns' });
  for (const quantity of alongSection) envelopeFigure(box, quantity);
  const cells = runs.filter(({ envelopes }) => envelopes.rows.length > 0).map(cellText);
  const text = `${startOfSentence(cells.join('; '))}. Energies, velocities and heights are those of the rocks that pass.`;
  element(parent, 'p', text, { class: 'quiet' });
}
