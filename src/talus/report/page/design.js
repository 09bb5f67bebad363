// Barrier design: demands of the rocks along each line, requirements of the check, and the ranked kits.

const designsOf = () => runs.filter((run) => run.summary.design);
const shareText = (share) => share ? `${number(100 * share.value, 3)} %` : '–';
const rangeText = ([value, low, high], per, digits = 4) => value === undefined ? '–' :
  `${measured(value / per, digits)} (${isNumber(low) ? measured(low / per, digits) : '…'} to ${isNumber(high) ? measured(high / per, digits) : '…'})`;
const inUnit = (value, per) => isNumber(value) ? value / per : null;

// A table cell with a value and its interval below.
function rangeCell([value, low, high], per, digits = 4) {
  if (value === undefined) return '–';
  const end = (v) => isNumber(v) ? measured(v / per, digits) : '…';
  return {text: measured(value / per, digits), below: `${end(low)} to ${end(high)}`};
}
const shareCell = (share) => share ? {text: shareText(share), below: `${number(100 * share.low, 3)} to ${number(100 * share.high, 3)} %`} : '–';
const sufficesText = (kit) => (kit.suffices ? 'yes' : kit.limited_by ? `no: ${kit.limited_by}` : 'no') + (kit.sure === false ? ', uncertain' : '');
const classText = (needs) => needs ? `${needs.class}` : '–';

const energyWord = (design) => design.factors.of_total_energy ? 'total kinetic' : 'translational';

// Quantities by their names in the summary; the energy is the one that the check uses.
function designQuantities(design) {
  const total = design.factors.of_total_energy;
  return [
    {key: total ? 'ke_total_J' : 'ke_translational_J', text: `${total ? 'Total kinetic' : 'Translational'} energy`, unit: 'kJ', per: 1000},
    {key: 'velocity_m_s', text: 'Velocity', unit: 'm/s', per: 1},
    {key: 'height_m', text: 'Height above the foot', unit: 'm', per: 1},
  ];
}

// Panels along the line: the number of rocks, then for each quantity its percentiles with confidence intervals.
function alongFigure(parent, run, line) {
  const quantities = designQuantities(run.summary.design);
  const names = Object.keys((line.sections.find((s) => s.rocks) || {percentiles: {[quantities[0].key]: {}}}).percentiles[quantities[0].key]);
  const colour = (i) => `var(--m${(i + 2) % 6})`;
  const title = single ? `Along ${line.name}` : `Along ${line.name} · ${run.label}`;
  figure(parent, {
    title, label: `Rocks and percentiles of energy, velocity and height along ${line.name}`, width: drawing.wide,
    caption: `Each step is a section of the line. Lines: percentiles. Shaded: their ${number(100 * run.summary.design.confidence)} % confidence intervals, which have no upper end where a section has too few rocks.`,
    draw(svg, width) {
      const left = 82, right = width - 14, tall = 130, gap = 50;
      const toX = d3.scaleLinear().domain([0, line.length_m]).range([left, right]);
      let top = 26;
      const panel = (values, yLabel, height, xLabel = '') => {
        const side = {left, right, top, bottom: top + height};
        const toY = d3.scaleLinear().domain([0, (d3.max(values) || 1) * 1.06]).range([side.bottom, side.top]);
        axes(svg, toX, toY, side, {xLabel, yLabel: '', yTicks: 4});
        svg.append('text').attr('class', 'axis-label').attr('x', left).attr('y', side.top - 8).text(yLabel);
        top = side.bottom + gap;
        return toY;
      };
      const widthOf = (s) => Math.max(toX(s.to_m) - toX(s.from_m), 1);
      const toRocks = panel(line.sections.map((s) => s.rocks), 'Rocks', 70);
      tip(svg.append('g').style('--run', run.colour).selectAll('rect').data(line.sections.filter((s) => s.rocks)).enter().append('rect').attr('class', 'bar')
        .attr('x', (s) => toX(s.from_m)).attr('width', (s) => Math.max(widthOf(s) - 0.5, 1)).attr('y', (s) => toRocks(s.rocks)).attr('height', (s) => toRocks(0) - toRocks(s.rocks)),
      (s) => `${number(s.from_m, 5)} to ${number(s.to_m, 5)} m\n${count(s.rocks, 'rock')}, ${shareText(s.share)} of all\n` +
        (s.share ? `${number(100 * s.share.low, 3)} to ${number(100 * s.share.high, 3)} %` : ''));
      for (const {key, text, unit, per} of quantities) {
        const marks = line.sections.flatMap((s) => Object.entries(s.percentiles[key]).map(([name, [value, low, high]], i) => ({s, name, i, value, low, high})));
        const toY = panel(marks.flatMap((m) => [m.value, m.high]).filter(isNumber).map((v) => v / per), `${text} [${unit}]`, tall, key === 'height_m' ? 'Distance along the line on plan [m]' : '');
        svg.append('g').selectAll('rect').data(marks.filter((m) => isNumber(m.low) || isNumber(m.high))).enter().append('rect').attr('class', 'band').style('--run', (m) => colour(m.i))
          .attr('x', (m) => toX(m.s.from_m)).attr('width', (m) => widthOf(m.s)).attr('y', (m) => toY((isNumber(m.high) ? m.high : m.value) / per))
          .attr('height', (m) => toY((isNumber(m.low) ? m.low : m.value) / per) - toY((isNumber(m.high) ? m.high : m.value) / per));
        tip(svg.append('g').selectAll('line').data(marks).enter().append('line').attr('class', 'step').style('--run', (m) => colour(m.i))
          .attr('x1', (m) => toX(m.s.from_m)).attr('x2', (m) => toX(m.s.from_m) + widthOf(m.s)).attr('y1', (m) => toY(m.value / per)).attr('y2', (m) => toY(m.value / per)),
        (m) => `${number(m.s.from_m, 5)} to ${number(m.s.to_m, 5)} m, ${count(m.s.rocks, 'rock')}\np${m.name}: ${rangeText([m.value, m.low, m.high], per)} ${unit}`);
      }
      return legend(svg, names.map((name, i) => ({text: `percentile ${name}`, draw: sign.line('step', colour(i))})), left, top + 14, right) + 14;
    },
    rows: () => [['from_m', 'to_m', 'rocks', 'share', ...quantities.flatMap(({key}) => names.flatMap((name) => ['', ' low', ' high'].map((end) => `${key.replace(/_J$/, '_kJ')} p${name}${end}`)))],
      ...line.sections.map((s) => [s.from_m, s.to_m, s.rocks, (s.share || {}).value, ...quantities.flatMap(({key, per}) => names.flatMap((name) => [0, 1, 2].map((i) => inUnit((s.percentiles[key][name] || [])[i], per))))])],
  });
}

function designLines(parent, run) {
  const {design} = run.summary;
  const confidence = `${number(100 * design.confidence)} %`;
  const quantities = designQuantities(design);
  const names = [...new Set(design.lines.flatMap((line) => Object.keys(line.percentiles[quantities[0].key])))];
  table(parent, {
    caption: `Rocks that cross each line; below each value its ${confidence} confidence interval`,
    head: [['Line', {text: 'Length', unit: 'm'}, 'Rocks', 'Share of all', 'Percentile', ...quantities.map(({text, unit}) => ({text, unit}))]],
    rows: design.lines.flatMap((line) => (line.rocks ? names : ['–']).map((name, i) => [
      i ? '' : line.name, i ? '' : line.length_m ? number(line.length_m, 5) : '–', i ? '' : number(line.rocks),
      i ? '' : shareCell(line.share),
      name, ...quantities.map(({key, per}) => rangeCell(line.percentiles[key][name] || [], per)),
    ])),
    numeric: (column) => column > 0,
  });
}

function designCheck(parent, run) {
  const {design} = run.summary;
  const {factors} = design;
  const needs = (n) => [n ? measured(n.energy_J / 1000) : '–', classText(n), n ? measured(n.height_m, 3) : '–'];
  const worst = (line, key) => d3.max(line.sections.filter((s) => s.needs), (s) => s.needs[key]);
  const worstClass = (line) => worst(line, 'class') ?? '–';
  table(parent, {
    caption: (design.standard ? `Requirements of the check of ${design.standard}` : 'Requirements without the factors of a standard') +
      `, by ${energyWord(design)} energy`,
    head: [
      ['', {text: `By percentile ${number(design.design_percentile)}`, span: 3}, {text: 'By the upper ends of its interval', span: 3}, {text: 'Worst section', span: 3}],
      ['Line', {text: 'MEL', unit: 'kJ'}, 'Class', {text: 'Height', unit: 'm'}, {text: 'MEL', unit: 'kJ'}, 'Class', {text: 'Height', unit: 'm'}, {text: 'MEL', unit: 'kJ'}, 'Class', {text: 'Height', unit: 'm'}],
    ],
    rows: design.lines.map((line) => [line.name, ...needs(line.needs), ...needs(line.needs_at_upper_end),
      measured(kJ(worst(line, 'energy_J'))), String(worstClass(line)), measured(worst(line, 'height_m'), 3)]),
    numeric: (column) => column > 0,
  });
  const factorsText = design.standard ? `Factors: trajectory ${number(factors.trajectory)}, topography ${number(factors.topography)}, volume ${number(factors.volume)}, density ${number(factors.density)}, ` +
    `risk ${number(factors.risk)}, energy ${number(factors.energy)} (${factors.level}); upper clearance ${number(factors.clearance_m)} m or half the block. ` : '';
  const block = isNumber(factors.block_mass_kg) ? `Energy and size in the check are those of a design block of ${number(factors.block_mass_kg)} kg. ` : '';
  element(parent, 'p', `${factorsText}${block}Each column of the worst section has the maximum of all sections. Classes are those of EAD 340059-00-0106; class 8 is above 4,500 kJ. The deflection of the net, foundations and simultaneous impacts of several rocks are not checked.`, {class: 'quiet'});
}

function designRanking(parent, run) {
  const {design} = run.summary;
  const shown = design.ranking.slice(0, 15);
  const best = design.best;
  const wanted = `${number(100 * design.catch_share)} %`;
  const of = (run.project.design || {}).protect ? `the rocks that reach ${run.project.design.protect}` : 'the rocks that reach its line';
  element(parent, 'p', best ? `Lowest-cost kit that catches ${wanted} of ${of}: ${best.line}, ${number(best.height_m)} m high, ${number(best.energy_J / 1000)} kJ of ${energyWord(design)} energy${isNumber(best.class) ? ` (class ${best.class})` : ''}; it catches ${shareText(best.caught_share)}${best.sure === false ? ' (uncertain)' : ''}.`
    : `None of the given kits catches ${wanted} of ${of}.`);
  if (!best) {
    const first = design.lines.map((line) => design.ranking.find((kit) => kit.line === line.name && kit.limit)).filter(Boolean);
    for (const kit of first) element(parent, 'p', `${kit.line}: ${kit.limit}.`);
  }
  table(parent, {
    caption: `${best ? 'Kits, the best first' : 'Kits, none of which suffices'}; ${energyWord(design)} energy; below each share its ${number(100 * design.confidence)} % confidence interval`,
    head: [['Line', {text: 'Height', unit: 'm'}, {text: 'MEL', unit: 'kJ'}, 'Class', 'Caught', 'Too high', 'Too energetic', 'Beyond the ends', 'Suffices', 'Cost index']],
    rows: shown.map((kit) => [kit.line, number(kit.height_m), number(kit.energy_J / 1000), isNumber(kit.class) ? String(kit.class) : '–', shareCell(kit.caught_share),
      number(kit.above), number(kit.through), number(kit.beside), sufficesText(kit), measured(kit.cost)]),
    numeric: (column) => column > 0,
    rowClass: (i) => i === 0 && best ? 'differs' : '',
  });
  if (shown.some((kit) => kit.sure === false)) {
    element(parent, 'p', `Uncertain: the required ${wanted} is within the ${number(100 * design.confidence)} % confidence interval of the share. Run more rocks, or choose a kit that is certain.`);
  }
  const more = design.ranking.length - shown.length;
  element(parent, 'p', (more > 0 ? `${count(more, 'more kit is', 'more kits are')} in design_ranking.csv. ` : '') +
    'A kit catches a rock if it passes the check for that rock. For each line and height the lowest sufficient energy is listed. The cost index is length × height to a power × energy to a power, both from the settings: it compares kits and is not a price.', {class: 'quiet'});
}

function designSections(parent) {
  for (const run of designsOf()) {
    if (!single) element(parent, 'h3', run.label);
    designLines(parent, run);
    designCheck(parent, run);
    designRanking(parent, run);
    for (const line of run.summary.design.lines) {
      if (line.sections.length > 1 && line.rocks) alongFigure(parent, run, line);
    }
  }
}
