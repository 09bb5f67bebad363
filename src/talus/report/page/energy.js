// Mechanical, kinetic and potential energy of one rock along its way.

const energyAxes = {
  x: {text: 'x', label: 'x [m]', of: (rows) => rows.map((row) => row.x)},
  travelled: {
    text: 'distance travelled', label: 'Distance travelled on plan [m]',
    of(rows) {
      let sum = 0;
      return rows.map((row, i) => i === 0 ? 0 : sum += Math.hypot(row.x - rows[i - 1].x, row.y - rows[i - 1].y));
    },
  },
  time: {text: 'time', label: 'Time since release [s]', of: (rows) => rows.map((row) => row.time)},
};

// In flight every axis above grows evenly with time while energy is a quadratic of it, so a leg is again an exact
// quadratic Bézier curve. `slope` is the energy's rate of change on departure.
function energyPath(rows, places, energyOf, slope, toX, toY) {
  return rows.map((row, i) => {
    const to = `${toX(places[i]).toFixed(2)},${toY(energyOf(row)).toFixed(2)}`;
    if (i === 0) return 'M' + to;
    const from = rows[i - 1];
    if (from.state !== 'projectile') return 'L' + to;
    const half = (row.time - from.time) / 2;
    return `Q${toX((places[i - 1] + places[i]) / 2).toFixed(2)},${toY(energyOf(from) + slope(from) * half).toFixed(2)} ${to}`;
  }).join('');
}

function energyFigure(parent, run, width) {
  // In space x says nothing of how far a rock came.
  const axisNames = run.isSection ? ['x', 'travelled', 'time'] : ['travelled', 'time'];
  let [axis] = axisNames;
  const kinetic = (row) => (row.ke_translational + row.ke_rotational) / 1000;
  const potential = (row) => row.pe / 1000;
  const mechanical = (row) => kinetic(row) + potential(row);
  const made = figure(parent, {
    title: single ? 'Energy of one rock along its path' : `Energy of one rock along its path · ${run.label}`,
    label: 'Mechanical, total kinetic and potential energy of the chosen rock along its path',
    caption: 'Total kinetic energy is that of translation and rotation; mechanical energy is total kinetic and potential energy. Potential energy is measured from the datum of the model. Dots are the rows of the path; a vertical drop is the loss at an impact.',
    width,
    draw(svg) {
      const rock = choice.rocks[run.index];
      const {rows} = rock;
      const side = {left: 78, right: width - 14, top: 12, bottom: 252};
      const places = energyAxes[axis].of(rows);
      const values = rows.flatMap((row) => [mechanical(row), kinetic(row), potential(row)]);
      const toX = d3.scaleLinear().domain(extentOf(places, 0.02)).range([side.left, side.right]);
      const toY = d3.scaleLinear().domain(extentOf([0, ...values])).range([side.bottom, side.top]);
      axes(svg, toX, toY, side, {xLabel: energyAxes[axis].label, yLabel: 'Energy [kJ]'});
      // The rock's weight in kN, from two rows of unlike height.
      const low = rows.reduce((a, b) => b.z < a.z ? b : a), high = rows.reduce((a, b) => b.z > a.z ? b : a);
      const weight = high.z > low.z ? (potential(high) - potential(low)) / (high.z - low.z) : 0;
      const curves = [
        ['potential', potential, (row) => weight * row.vz],
        ['kinetic', kinetic, (row) => -weight * row.vz],
        ['mechanical', mechanical, () => 0],
      ];
      for (const [name, energyOf, slope] of curves) {
        svg.append('path').attr('class', 'energy ' + name).attr('d', energyPath(rows, places, energyOf, slope, toX, toY));
        tip(svg.append('g').selectAll('circle').data(rows).enter().append('circle').attr('class', 'stop ' + name).attr('r', 3.4)
          .attr('cx', (row, i) => toX(places[i])).attr('cy', (row) => toY(energyOf(row))),
        (row) => `${row.state} at ${number(row.time, 5)} s\nx ${metres(row.x)}, z ${metres(row.z)}\nmechanical ${number(mechanical(row), 6)} kJ\n` +
          `total kinetic ${number(kinetic(row), 6)} kJ\npotential ${number(potential(row), 6)} kJ`);
      }
      return legend(svg, [['mechanical', 'mechanical'], ['kinetic', 'total kinetic'], ['potential', 'potential']].map(([name, words]) => ({text: words + ' energy', draw: sign.line('energy ' + name)})),
        side.left, side.bottom + 56, side.right) + 12;
    },
    rows: () => [['rock', 'state', 'time_s', 'x_m', 'y_m', 'z_m', 'total_kinetic_kJ', 'potential_kJ', 'mechanical_kJ'],
      ...choice.rocks[run.index].rows.map((row) => [choice.rocks[run.index].rock, row.state, row.time, row.x, row.y, row.z, kinetic(row), potential(row), mechanical(row)])],
  });
  const pick = (words, options, value, onPick) => {
    const label = made.head.insert('label', '.save').text(words + ' ');
    const select = label.append('select');
    for (const [key, text] of options) element(select, 'option', text, {value: key});
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

function energyFigures(parent) {
  const shown = runs.filter((run) => run.rocks.length);
  if (!shown.length) return element(parent, 'p', 'There are no paths to take energies from.', {class: 'quiet'});
  const box = element(parent, 'div', null, {class: shown.length > 1 ? 'columns' : ''});
  for (const run of shown) energyFigure(box, run, shown.length > 1 ? drawing.half : drawing.wide);
}
