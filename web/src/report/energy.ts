// Mechanical, kinetic and potential energy of one rock along its trajectory.

import * as figures from '../figures/report';
import { drawing, element, figure } from './figure';
import { amountIn, displayOf, lengthText, measured, number, unitIn } from './format';
import { runs, single, xyText } from './run';
import { choice, choose } from './slope';

const energyAxes = {
  x: {text: 'x', label: 'x', unit: 'm', of: (rows) => rows.map((row) => row.x)},
  travelled: {
    text: 'distance travelled', label: 'Distance travelled on plan', unit: 'm',
    of(rows) {
      let sum = 0;
      return rows.map((row, i) => i === 0 ? 0 : sum += Math.hypot(row.x - rows[i - 1].x, row.y - rows[i - 1].y));
    },
  },
  time: {text: 'time', label: 'Time since release', unit: 's', of: (rows) => rows.map((row) => row.time)},
};

// The weight of a rock [N], from the potential energies at its lowest and highest row; 0 if its height never changes.
function weightOf(rows) {
  const low = rows.reduce((a, b) => b.z < a.z ? b : a), high = rows.reduce((a, b) => b.z > a.z ? b : a);
  return high.z > low.z ? (high.pe - low.pe) / (high.z - low.z) : 0;
}

// In flight every axis above is linear in time, and the energies are quadratic in it.
function energyRows(run, rows, axis) {
  const {of, unit} = energyAxes[axis];
  const places = of(rows), weight = weightOf(rows);
  return rows.map((row, i) => ({
    place: amountIn(unit, places[i]), translational: row.ke_translational, rotational: row.ke_rotational, potential: row.pe,
    rise: row.state === 'projectile' && i + 1 < rows.length ? weight * row.vz * (rows[i + 1].time - row.time) / 2 : null,
    text: `${row.state} at ${measured(row.time)} s\nx ${xyText(run, row.x)}, z ${lengthText(row.z)}`,
  }));
}

function energyFigure(parent, run, width) {
  // In 3D, x is not a measure of the distance travelled.
  const axisNames = run.isSection ? ['x', 'travelled', 'time'] : ['travelled', 'time'];
  let [axis] = axisNames;
  const made = figure(parent, {
    title: single ? 'Energy of one rock along its trajectory' : `Energy of one rock along its trajectory · ${run.label}`,
    label: 'Mechanical, total kinetic and potential energy of the selected rock along its trajectory',
    caption: 'Total kinetic energy is translational plus rotational; mechanical energy is total kinetic plus potential energy. Potential energy is measured from the datum of the model. Dots are the recorded events; a vertical drop is the loss at an impact.',
    width, tall: width === drawing.wide ? 320 : 338,
    fill: (element, room) => figures.energy(element, room, {xLabel: `${energyAxes[axis].label} [${unitIn(energyAxes[axis].unit)}]`, rows: energyRows(run, choice.rocks[run.index].rows, axis), hasDots: true, ...displayOf('J')}),
    rows: () => [['rock', 'state', 'time_s', 'x_m', 'y_m', 'z_m', 'ke_translational_J', 'ke_rotational_J', 'pe_J'],
      ...choice.rocks[run.index].rows.map((row) => [choice.rocks[run.index].rock, row.state, row.time, row.x, row.y, row.z, row.ke_translational, row.ke_rotational, row.pe])],
  });
  const pick = (text, options, value, onPick) => {
    const label = made.head.insert('label', '.save').text(text + ' ');
    const select = label.append('select');
    for (const [key, option] of options) element(select, 'option', option, {value: key});
    select.property('value', value).on('change', function () { onPick(this.value); });
    return select;
  };
  const rocks = pick('Rock', run.rocks.map((rock, i) => [i, rock.rock]), run.rocks.indexOf(choice.rocks[run.index]), (i) => choose(run.rocks[i]));
  const chosen = made.head.insert('span', '.save').attr('class', 'quiet');
  pick('along', axisNames.map((name) => [name, energyAxes[name].text]), axis, (key) => { axis = key; made.redraw(); });
  const follow = () => {
    rocks.property('value', run.rocks.indexOf(choice.rocks[run.index]));
    chosen.text(`(of ${number(run.rocks.length)} shown)`);
  };
  follow();
  choice.listeners.push(() => { made.redraw(); follow(); });
}

export function energyFigures(parent) {
  const shown = runs.filter((run) => run.rocks.length);
  if (!shown.length) return element(parent, 'p', 'No trajectories are recorded to draw energies from.', {class: 'quiet'});
  const box = element(parent, 'div', null, {class: shown.length > 1 ? 'columns' : ''});
  for (const run of shown) energyFigure(box, run, shown.length > 1 ? drawing.half : drawing.wide);
}
