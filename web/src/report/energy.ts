// Mechanical, kinetic and potential energy of one rock along its trajectory.

import { energy, type EnergyRow } from '../figures/energy';
import type { Group } from '../figures/plot';
import type { PathRow, Rock } from './data';
import { drawing, element, figure } from './figure';
import { amountIn, displayOf, lengthText, measured, number, unitIn } from './format';
import { runs, single, xyText, type Run } from './run';
import { choice, choose } from './choice';

interface EnergyAxis {
  text: string;
  label: string;
  unit: string;
  of: (rows: readonly PathRow[]) => number[];
}
const energyAxes = {
  x: { text: 'x', label: 'x', unit: 'm', of: (rows) => rows.map(({ x }) => x) },
  travelled: { text: 'distance travelled', label: 'Distance travelled on plan', unit: 'm', of: distancesOf },
  time: { text: 'time', label: 'Time since release', unit: 's', of: (rows) => rows.map(({ time }) => time) },
} satisfies Record<string, EnergyAxis>;
type AxisName = keyof typeof energyAxes;

function distancesOf(rows: readonly PathRow[]): number[] {
  let sum = 0;
  return rows.map(({ x, y }, k) => {
    const before = rows[k - 1];
    if (before) sum += Math.hypot(x - before.x, y - before.y);
    return sum;
  });
}

// The weight of a rock [N], from the potential energies at its lowest and highest row; 0 if its height never changes.
function weightOf(rows: readonly PathRow[]): number {
  const low = rows.reduce((a, b) => (b.z < a.z ? b : a));
  const high = rows.reduce((a, b) => (b.z > a.z ? b : a));
  return high.z > low.z ? (high.pe - low.pe) / (high.z - low.z) : 0;
}

// In flight every axis above is linear in time, and the energies are quadratic in it.
function energyRows(run: Run, rows: readonly PathRow[], axis: AxisName): EnergyRow[] {
  const { of, unit } = energyAxes[axis];
  const places = of(rows);
  const weight = weightOf(rows);
  return rows.map((row, k) => {
    const next = rows[k + 1];
    return {
      place: amountIn(unit, places[k]!),
      translational: row.ke_translational,
      rotational: row.ke_rotational,
      potential: row.pe,
      rise: row.state === 'projectile' && next ? (weight * row.vz * (next.time - row.time)) / 2 : null,
      text: `${row.state} at ${measured(row.time)} s\nx ${xyText(run, row.x)}, z ${lengthText(row.z)}`,
    };
  });
}

// Adds a choice to the head of a figure.
function pick<Key extends string>(
  head: Group,
  text: string,
  options: readonly (readonly [Key, string])[],
  onPick: (key: Key) => void,
): Group {
  const select: Group = head.insert('label', '.save').text(`${text} `).append('select');
  for (const [key, option] of options) element(select, 'option', option, { value: key });
  return select.on('change', () => {
    const [chosen] = options.find(([key]) => key === select.property('value')) ?? [];
    if (chosen !== undefined) onPick(chosen);
  });
}

function energyFigure(parent: Group, run: Run, first: Rock, width: number) {
  // In 3D, x is not a measure of the distance travelled.
  const axisNames: AxisName[] = run.isSection ? ['x', 'travelled', 'time'] : ['travelled', 'time'];
  let axis: AxisName = run.isSection ? 'x' : 'travelled';
  const chosen = () => choice.rocks[run.index] ?? first;
  const title = 'Energy of one rock along its trajectory';
  const made = figure(parent, {
    title: single ? title : `${title} · ${run.label}`,
    label: 'Mechanical, total kinetic and potential energy of the selected rock along its trajectory',
    caption:
      'Total kinetic energy is translational plus rotational; mechanical energy is total kinetic plus potential energy. ' +
      'Potential energy is measured from the datum of the model. Dots are the recorded events; a vertical drop is the loss ' +
      'at an impact.',
    width,
    tall: width === drawing.wide ? 320 : 338,
    fill: (svg, room) => {
      const { label, unit } = energyAxes[axis];
      const rows = energyRows(run, chosen().rows, axis);
      energy(svg, room, { xLabel: `${label} [${unitIn(unit)}]`, rows, hasDots: true, ...displayOf('J') });
    },
    rows: () => [
      ['rock', 'state', 'time_s', 'x_m', 'y_m', 'z_m', 'ke_translational_J', 'ke_rotational_J', 'pe_J'],
      ...chosen().rows.map((row) => [
        ...[chosen().rock, row.state, row.time, row.x, row.y, row.z],
        ...[row.ke_translational, row.ke_rotational, row.pe],
      ]),
    ],
  });
  const numbers = run.rocks.map(({ rock }, k) => [String(k), String(rock)] as const);
  const rocks = pick(made.head, 'Rock', numbers, (k) => {
    const rock = run.rocks[Number(k)];
    if (rock) choose(rock);
  });
  made.head.insert('span', '.save').attr('class', 'quiet').text(`(of ${number(run.rocks.length)} shown)`);
  const axisTexts = axisNames.map((name) => [name, energyAxes[name].text] as const);
  pick(made.head, 'along', axisTexts, (name) => {
    axis = name;
    made.redraw();
  });
  const follow = () => rocks.property('value', run.rocks.indexOf(chosen()));
  follow();
  choice.listeners.push(() => {
    made.redraw();
    follow();
  });
}

export function energyFigures(parent: Group) {
  const shown = runs.flatMap((run) => (run.rocks[0] ? [{ run, first: run.rocks[0] }] : []));
  if (shown.length === 0) {
    element(parent, 'p', 'No trajectories are recorded to draw energies from.', { class: 'quiet' });
    return;
  }
  const box = element(parent, 'div', null, { class: shown.length > 1 ? 'columns' : '' });
  const width = shown.length > 1 ? drawing.half : drawing.wide;
  for (const { run, first } of shown) energyFigure(box, run, first, width);
}
