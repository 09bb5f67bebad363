// Barrier design: demands of the rocks along each line, requirements of the check, and the ranked kits.

import * as d3 from '../figures/d3';
import { axes, legend, sign, tip } from '../figures/report';
import { drawing, element, figure } from './figure';
import { axisIn, count, givenIn, givenLength, inSavedUnit, isNumber, measured, number, resultIn, unitIn } from './format';
import { runs, single } from './run';
import { table } from './tables';

export const designsOf = () => runs.filter((run) => run.summary.design);
const shareText = (share) => share ? `${number(100 * share.value, 3)} %` : '–';
const endIn = (unit, end) => isNumber(end) ? resultIn(unit, end) : '…';
const rangeText = ([value, low, high], unit) => value === undefined ? '–' : `${resultIn(unit, value)} (${endIn(unit, low)} to ${endIn(unit, high)})`;

// A table cell with a value and its interval below.
const rangeCell = ([value, low, high], unit) => value === undefined ? '–' :
  {text: resultIn(unit, value), below: `${endIn(unit, low)} to ${endIn(unit, high)}`};
const shareCell = (share) => share ? {text: shareText(share), below: `${number(100 * share.low, 3)} to ${number(100 * share.high, 3)} %`} : '–';
const sufficesText = (kit) => (kit.suffices ? 'yes' : kit.limited_by ? `no: ${kit.limited_by}` : 'no') + (kit.sure === false ? ', uncertain' : '');
const classText = (needs) => needs ? `${needs.class}` : '–';

const knownLength = (metres) => resultIn('m', metres, 3);
const stretchText = ({from_m, to_m}) => `${givenIn('m', from_m, 5)} to ${givenLength(to_m, 5)}`;
const isPriced = (run) => (run.project.kit || []).some((kit) => isNumber(kit.cost_per_m));
const costTitle = (run) => isPriced(run) ? 'Cost' : 'Cost index';

const energyWord = (design) => design.factors.of_total_energy ? 'total kinetic' : 'translational';

// Quantities by their names in the summary; the energy is the one that the check uses.
function designQuantities(design) {
  const total = design.factors.of_total_energy;
  return [
    {key: total ? 'ke_total_J' : 'ke_translational_J', text: `${total ? 'Total kinetic' : 'Translational'} energy`, unit: 'J'},
    {key: 'velocity_m_s', text: 'Velocity', unit: 'm/s'},
    {key: 'height_m', text: "Height of the block's top above the foot", unit: 'm'},
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
      const panel = (values, unit, yLabel, height, xLabel = '') => {
        const side = {left, right, top, bottom: top + height};
        const toY = d3.scaleLinear().domain([0, (d3.max(values) || 1) * 1.06]).range([side.bottom, side.top]);
        axes(svg, axisIn('m', toX), axisIn(unit, toY), side, {xLabel, yLabel: '', yTicks: 4});
        svg.append('text').attr('class', 'axis-label').attr('x', left).attr('y', side.top - 8).text(yLabel);
        top = side.bottom + gap;
        return toY;
      };
      const widthOf = (s) => Math.max(toX(s.to_m) - toX(s.from_m), 1);
      const toRocks = panel(line.sections.map((s) => s.rocks), '', 'Rocks', 70);
      tip(svg.append('g').style('--run', run.colour).selectAll('rect').data(line.sections.filter((s) => s.rocks)).enter().append('rect').attr('class', 'bar')
        .attr('x', (s) => toX(s.from_m)).attr('width', (s) => Math.max(widthOf(s) - 0.5, 1)).attr('y', (s) => toRocks(s.rocks)).attr('height', (s) => toRocks(0) - toRocks(s.rocks)),
      (s) => `${stretchText(s)}\n${count(s.rocks, 'rock')}, ${shareText(s.share)} of all\n` +
        (s.share ? `${number(100 * s.share.low, 3)} to ${number(100 * s.share.high, 3)} %` : ''));
      for (const {key, text, unit} of quantities) {
        const marks = line.sections.flatMap((s) => Object.entries(s.percentiles[key]).map(([name, [value, low, high]], i) => ({s, name, i, value, low, high})));
        const toY = panel(marks.flatMap((m) => [m.value, m.high]).filter(isNumber), unit, `${text} [${unitIn(unit)}]`, tall, key === 'height_m' ? `Distance along the line on plan [${unitIn('m')}]` : '');
        svg.append('g').selectAll('rect').data(marks.filter((m) => isNumber(m.low) || isNumber(m.high))).enter().append('rect').attr('class', 'band').style('--run', (m) => colour(m.i))
          .attr('x', (m) => toX(m.s.from_m)).attr('width', (m) => widthOf(m.s)).attr('y', (m) => toY(isNumber(m.high) ? m.high : m.value))
          .attr('height', (m) => toY(isNumber(m.low) ? m.low : m.value) - toY(isNumber(m.high) ? m.high : m.value));
        tip(svg.append('g').selectAll('line').data(marks).enter().append('line').attr('class', 'step').style('--run', (m) => colour(m.i))
          .attr('x1', (m) => toX(m.s.from_m)).attr('x2', (m) => toX(m.s.from_m) + widthOf(m.s)).attr('y1', (m) => toY(m.value)).attr('y2', (m) => toY(m.value)),
        (m) => `${stretchText(m.s)}, ${count(m.s.rocks, 'rock')}\np${m.name}: ${rangeText([m.value, m.low, m.high], unit)} ${unitIn(unit)}`);
      }
      return legend(svg, names.map((name, i) => ({text: `percentile ${name}`, draw: sign.line('step', colour(i))})), left, top + 14, right) + 14;
    },
    rows: () => [['from_m', 'to_m', 'rocks', 'share', ...quantities.flatMap(({key}) => names.flatMap((name) => ['', ' low', ' high'].map((end) => `${key.replace(/_J$/, '_kJ')} p${name}${end}`)))],
      ...line.sections.map((s) => [s.from_m, s.to_m, s.rocks, (s.share || {}).value, ...quantities.flatMap(({key, unit}) => names.flatMap((name) => [0, 1, 2].map((i) => inSavedUnit(unit, (s.percentiles[key][name] || [])[i]))))])],
  });
}

function designLines(parent, run) {
  const {design} = run.summary;
  const confidence = `${number(100 * design.confidence)} %`;
  const quantities = designQuantities(design);
  const names = [...new Set(design.lines.flatMap((line) => Object.keys(line.percentiles[quantities[0].key])))];
  table(parent, {
    caption: `Rocks that cross each line; below each value its ${confidence} confidence interval, from sampling alone`,
    head: [['Line', {text: 'Length', unit: unitIn('m')}, 'Rocks', 'Share of all', 'Percentile', ...quantities.map(({text, unit}) => ({text, unit: unitIn(unit)}))]],
    rows: design.lines.flatMap((line) => (line.rocks ? names : ['–']).map((name, i) => [
      i ? '' : line.name, i ? '' : line.length_m ? givenIn('m', line.length_m, 5) : '–', i ? '' : number(line.rocks),
      i ? '' : shareCell(line.share),
      name, ...quantities.map(({key, unit}) => rangeCell(line.percentiles[key][name] || [], unit)),
    ])),
    numeric: (column) => column > 0,
  });
}

// Every factor of the check with its source, and what could not be read there.
function designFactors(parent, design) {
  if (!design.standard || !design.applied_factors) return;
  table(parent, {
    caption: `Factors of the check of ${design.standard}`,
    head: [['Symbol', 'Multiplies', 'Value', 'Source', 'Could not be read there']],
    rows: design.applied_factors.map((f) => [{text: f.symbol, below: f.key}, f.multiplies, number(f.value), f.source, f.not_read || '–']),
    numeric: (column) => column === 2,
  });
  if (design.standard_not_read) element(parent, 'p', `${design.standard_not_read}.`, {class: 'quiet'});
}

function designCheck(parent, run) {
  const {design} = run.summary;
  const {factors} = design;
  const needs = (n) => [n ? resultIn('J', n.energy_J) : '–', classText(n), n ? resultIn('m', n.height_m, 3) : '–'];
  const worst = (line, key) => d3.max(line.sections.filter((s) => s.needs), (s) => s.needs[key]);
  const worstClass = (line) => worst(line, 'class') ?? '–';
  table(parent, {
    caption: (design.standard ? `Requirements of the check of ${design.standard}` : 'Requirements without the factors of a standard') +
      `, by ${energyWord(design)} energy`,
    head: [
      ['', {text: `By percentile ${number(design.design_percentile)}`, span: 3}, {text: 'By the upper ends of its interval', span: 3}, {text: 'Worst section', span: 3}],
      ['Line', {text: 'MEL', unit: unitIn('J')}, 'Class', {text: 'Height', unit: unitIn('m')}, {text: 'MEL', unit: unitIn('J')}, 'Class', {text: 'Height', unit: unitIn('m')}, {text: 'MEL', unit: unitIn('J')}, 'Class', {text: 'Height', unit: unitIn('m')}],
    ],
    rows: design.lines.map((line) => [line.name, ...needs(line.needs), ...needs(line.needs_at_upper_end),
      resultIn('J', worst(line, 'energy_J')), String(worstClass(line)), resultIn('m', worst(line, 'height_m'), 3)]),
    numeric: (column) => column > 0,
  });
  const clearance = `Upper clearance ${givenLength(factors.clearance_m)}${factors.clears_half_the_block ? ' or half the block' : ''}. `;
  const factorsText = design.standard ? `The kit's energy is its ${factors.level}. ${clearance}` : '';
  const elongations = design.lines.some((line) => isNumber(line.clearance_m));
  if (elongations) {
    table(parent, {
      caption: 'Distance on plan to what is protected, and the elongation that a kit may have there at most',
      head: [['Line', {text: 'Distance', unit: unitIn('m')}, {text: 'Elongation at most', unit: unitIn('m')}, 'Narrowest section']],
      rows: design.lines.filter((line) => isNumber(line.clearance_m)).map((line) => {
        const narrow = line.sections.reduce((least, s) => (least && least.clearance_m <= s.clearance_m ? least : s), null);
        return [line.name, resultIn('m', line.clearance_m, 3), isNumber(line.most_elongation_m) ? resultIn('m', line.most_elongation_m, 3) : 'needs elongation_factor',
          narrow ? stretchText(narrow) : '–'];
      }),
      numeric: (column) => column === 1 || column === 2,
    });
  }
  const block = isNumber(factors.block_mass_kg) ? `Energy and size in the check are those of a design block of ${givenIn('kg', factors.block_mass_kg)} ${unitIn('kg')}. ` : '';
  element(parent, 'p', `${factorsText}${block}Each column of the worst section has the maximum of all sections. Classes are those of EAD 340059-00-0106; class 8 is above 4,500 kJ. Foundations and simultaneous impacts of several rocks are not checked.`, {class: 'quiet'});
}

function designRanking(parent, run) {
  const {design} = run.summary;
  const shown = design.ranking.slice(0, 15);
  const best = design.best;
  const wanted = `${number(100 * design.catch_share)} %`;
  const of = (run.project.design || {}).protect ? `the rocks that reach ${run.project.design.protect}` : 'the rocks that reach its line';
  element(parent, 'p', best ? `Lowest-cost kit that catches ${wanted} of ${of}: ${best.line}, ${best.kit ? `${best.kit}, ` : ''}${givenLength(best.height_m)} high, ${givenIn('J', best.energy_J)} ${unitIn('J')} of ${energyWord(design)} energy${isNumber(best.class) ? ` (class ${best.class})` : ''}; it catches ${shareText(best.caught_share)}${best.sure === false ? ' (uncertain)' : ''}.`
    : `None of the given kits catches ${wanted} of ${of}.`);
  if (!best) {
    const first = design.lines.map((line) => design.ranking.find((kit) => kit.line === line.name && kit.limit)).filter(Boolean);
    for (const kit of first) element(parent, 'p', `${kit.line}: ${kit.limit}.`);
  }
  const named = shown.some((kit) => kit.kit);
  const residual = shown.some((kit) => isNumber(kit.residual_height_m));
  const clear = shown.some((kit) => isNumber(kit.needs_clearance_m));
  table(parent, {
    caption: `${best ? 'Kits, the best first' : 'Kits, none of which suffices'}; ${energyWord(design)} energy; below each share its ${number(100 * design.confidence)} % confidence interval`,
    head: [[named ? 'Line and kit' : 'Line', {text: 'Height', unit: unitIn('m')}, {text: 'MEL', unit: unitIn('J')}, 'Class', 'Caught', 'Too high', 'Too energetic', 'Beyond the ends', 'Suffices', costTitle(run)]],
    rows: shown.map((kit) => [kit.kit ? {text: kit.line, below: kit.kit} : kit.line, givenIn('m', kit.height_m), givenIn('J', kit.energy_J), isNumber(kit.class) ? String(kit.class) : '–', shareCell(kit.caught_share),
      number(kit.above), number(kit.through), number(kit.beside), sufficesText(kit), measured(kit.cost)]),
    numeric: (column) => column > 0,
    rowClass: (i) => i === 0 && best ? 'differs' : '',
  });
  if (shown.some((kit) => kit.sure === false)) {
    element(parent, 'p', `Uncertain: the required ${wanted} is within the ${number(100 * design.confidence)} % confidence interval of the share. Run more rocks, or choose a kit that is certain.`);
  }
  if (clear || residual) {
    table(parent, {
      caption: 'What the nets need behind them, and what an impact leaves of them',
      head: [['Line and kit', {text: 'Height', unit: unitIn('m')}, {text: 'Needs on plan', unit: unitIn('m')}, {text: 'There are', unit: unitIn('m')}, {text: 'Remains', unit: unitIn('m')}, 'Rocks below that']],
      rows: shown.map((kit) => [{text: kit.line, below: kit.kit}, givenIn('m', kit.height_m), knownLength(kit.needs_clearance_m), knownLength(kit.clearance_m), knownLength(kit.residual_height_m),
        shareCell(kit.below_residual_share)]),
      numeric: (column) => column > 0,
    });
  }
  if (residual) {
    element(parent, 'p', 'Remains: the height of the kit after an impact at its MEL, at least. Rocks below that: the share of the rocks that would still meet it, whatever their energy; no test says what it stops before it is repaired.', {class: 'quiet'});
  }
  if (design.free_end_m > 0) element(parent, 'p', `Rocks that cross within ${givenLength(design.free_end_m)} of an end of a line count as beyond the ends.`, {class: 'quiet'});
  const more = design.ranking.length - shown.length;
  element(parent, 'p', (more > 0 ? `${count(more, 'more kit is', 'more kits are')} in design_ranking.csv. ` : '') +
    `A kit catches a rock if it passes the check for that rock. ${named ? '' : 'For each line and height the lowest sufficient energy is listed. '}` +
    (isPriced(run) ? 'The cost is the price per metre of the kit times the length of the line.' : 'The cost index is length × height to a power × energy to a power, both from the settings: it compares kits and is not a price.'), {class: 'quiet'});
}

// Two lines one behind the other.
function designPairs(parent, run) {
  const {design} = run.summary;
  if (!design.pairs || !design.pairs.length) return;
  const shown = design.pairs.slice(0, 15);
  const lineCell = (kit) => ({text: kit.line, below: `${kit.kit ? `${kit.kit}, ` : ''}${givenLength(kit.height_m)}, ${givenIn('J', kit.energy_J)} ${unitIn('J')}`});
  const staggered = shown.some((pair) => isNumber(pair.overlap_m));
  table(parent, {
    caption: `Two lines, one behind the other, the best first; below each share its ${number(100 * design.confidence)} % confidence interval`,
    head: [['First line', 'Second line', 'Caught', 'By the first', 'Go on', 'By the second', 'Beyond both',
      ...(staggered ? [{text: 'Overlap', unit: unitIn('m')}] : []), 'Suffices', costTitle(run)]],
    rows: shown.map((pair) => [lineCell(pair.first), lineCell(pair.second), shareCell(pair.caught_share),
      number(pair.caught_by_first), number(pair.at_second), number(pair.caught_by_second), number(pair.beside),
      ...(staggered ? [{text: knownLength(pair.overlap_m), below: `needs ${knownLength(pair.needs_overlap_m)}`}] : []), sufficesText(pair), measured(pair.cost)]),
    numeric: (column) => column > 1,
    rowClass: (i) => i === 0 && shown[0].suffices ? 'differs' : '',
  });
  const more = design.pairs.length - shown.length;
  element(parent, 'p', `${more > 0 ? `${count(more, 'more pair is', 'more pairs are')} in design_pairs.csv. ` : ''}A rock is caught by a pair if either kit catches it; the second sees the rocks that the first does not catch. Rocks count by their tops; barriers that are built also stop rocks that hit them below that. ` +
    `Of each pair the cheapest kits for what they catch are listed.${staggered ? ' Needs: the overlap that the directions of the rocks ask for at the first line, by the design percentile.' : ''}`, {class: 'quiet'});
}

export function designSections(parent) {
  for (const run of designsOf()) {
    if (!single) element(parent, 'h3', run.label);
    designLines(parent, run);
    designCheck(parent, run);
    designFactors(parent, run.summary.design);
    designRanking(parent, run);
    designPairs(parent, run);
    for (const line of run.summary.design.lines) {
      if (line.sections.length > 1 && line.rocks) alongFigure(parent, run, line);
    }
  }
}
