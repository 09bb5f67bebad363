// How much energy rocks have along a section, how fast and how high they come: envelopes.csv, drawn cell by cell.

const alongSection = [
  {key: 'energy_total', title: 'Total kinetic energy along the section', label: 'Total kinetic energy', unit: 'kJ', per: 1},
  {key: 'velocity', title: 'Velocity along the section', label: 'Velocity', unit: 'm/s', per: 1},
  {key: 'bounce_height', title: 'Bounce height along the section', label: 'Bounce height', unit: 'm', per: 1},
  {key: 'reach_share', title: 'Share of rocks that get here', label: 'Share of rocks', unit: '%', per: 0.01},
];

// The columns of a quantity in the order of their curves, the greatest first: its maximum, percentiles, mean.
function envelopeCurves(run, key) {
  if (run.envelopes.columns.includes(key)) return [{column: key, words: 'share', style: 'greatest', dash: null}];
  const curves = run.envelopes.columns.filter((column) => column.startsWith(key + '_')).map((column) => {
    const figure = column.slice(key.length + 1).split('_')[0];
    if (figure === 'max') return {column, words: 'maximum', style: 'greatest', order: Infinity};
    if (figure === 'mean') return {column, words: 'mean', style: 'mean', order: -1};
    return {column, words: `percentile ${figure.slice(1)}`, style: 'percentile', order: Number(figure.slice(1))};
  }).sort((a, b) => b.order - a.order);
  return curves.map((curve, k) => ({...curve, dash: k === 0 ? null : ['7 3', '4 3', '2 3', '1 4'][Math.min(k - 1, 3)]}));
}

const envelopeCellWidth = (run) => (run.project.output || {}).raster_cell_m || 1;

// With their edges, from the middles that the file has.
function envelopeCells(run) {
  const cells = records(run.envelopes);
  const width = envelopeCellWidth(run);
  return cells.map((cell) => ({...cell, from: cell.from_x_m - width / 2, to: cell.to_x_m + width / 2}));
}

// A step between cells side by side; where no rock was the line is broken.
function envelopePath(cells, valueOf, toX, toY) {
  let text = '', isBroken = true;
  for (const cell of cells) {
    const value = valueOf(cell);
    if (value !== null) text += `${isBroken ? `M${toX(cell.from).toFixed(2)},` : 'V'}${toY(value).toFixed(2)}H${toX(cell.to).toFixed(2)}`;
    isBroken = value === null;
  }
  return text;
}

function envelopeFigure(parent, {key, title, label, unit, per}) {
  const shown = runs.map((run) => {
    const curves = envelopeCurves(run, key).map((curve) => ({...curve, of: (cell) => isNumber(cell[curve.column]) ? cell[curve.column] / per : null}));
    return {run, cells: envelopeCells(run), curves: single ? curves : curves.slice(0, 1)};
  }).filter(({cells, curves}) => cells.length && curves.length);
  if (!shown.length) return;
  const walls = shown.flatMap(({run}) => barriersOf(run).map((barrier) => ({name: barrier.name, x: (barrierLine(barrier)[0] || [])[0]})))
    .filter((wall, i, all) => isNumber(wall.x) && all.findIndex((w) => w.name === wall.name && w.x === wall.x) === i);
  figure(parent, {
    title, label: `${title}, in ${unit}`,
    caption: '',
    draw(svg, width) {
      const side = {left: 66, right: width - 12, top: 12, bottom: 212};
      const all = shown.flatMap(({cells, curves}) => curves.flatMap(({of}) => cells.map(of)));
      const toX = d3.scaleLinear().domain(extentOf(shown.flatMap(({cells}) => cells.flatMap(({from, to}) => [from, to])), 0.02)).range([side.left, side.right]);
      const toY = d3.scaleLinear().domain([0, (d3.max(all) || 1) * 1.06]).range([side.bottom, side.top]);
      axes(svg, toX, toY, side, {xLabel: 'x [m]', yLabel: `${label} [${unit}]`});
      for (const {name, x} of walls) {
        svg.append('line').attr('class', 'barrier thin').attr('x1', toX(x)).attr('x2', toX(x)).attr('y1', side.bottom).attr('y2', side.top);
        svg.append('text').attr('class', 'barrier-name halo').attr('x', toX(x) + 5).attr('y', side.top + 13).text(name);
      }
      for (const {run, cells, curves} of shown) {
        for (const curve of curves) {
          svg.append('path').attr('class', `envelope ${curve.style}`).style('--run', run.colour).style('stroke-dasharray', curve.dash)
            .attr('d', envelopePath(cells, curve.of, toX, toY));
        }
      }
      tip(svg.append('g').selectAll('rect').data(shown[0].cells).enter().append('rect').attr('class', 'under-pointer')
        .attr('x', (cell) => toX(cell.from)).attr('width', (cell) => toX(cell.to) - toX(cell.from)).attr('y', side.top).attr('height', side.bottom - side.top),
      (cell) => [`x ${number(cell.from, 6)} to ${metres(cell.to)}`, ...shown.flatMap(({run, cells, curves}) => {
        const here = cells.find((other) => other.from <= (cell.from + cell.to) / 2 && (cell.from + cell.to) / 2 < other.to);
        return curves.map(({words, of}) => `${single ? words : `${run.label}, ${words}`} ${here && of(here) !== null ? `${number(of(here), 5)} ${unit}` : '–'}`);
      })].join('\n'));
      const signs = shown.flatMap(({run, curves}) => curves.map((curve) => ({
        text: single ? curve.words : `${run.label}, ${curve.words}`,
        draw: (g) => g.append('line').attr('class', `envelope ${curve.style}`).attr('x2', 22).style('--run', run.colour).style('stroke-dasharray', curve.dash),
      })));
      return signs.length > 1 ? legend(svg, signs, side.left, side.bottom + 54, side.right) + 12 : side.bottom + 42;
    },
    rows: () => [['run', 'from_x_m', 'to_x_m', ...shown[0].curves.map(({column}) => column)], ...shown.flatMap(({run, cells}) =>
      cells.map((cell) => [run.label, cell.from, cell.to, ...shown[0].curves.map(({column}) => cell[column])]))],
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
