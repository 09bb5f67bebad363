// Each barrier and collector: hits, energies and heights.

import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, tip } from '../figures/report';
import { histogramFigure } from './distributions';
import { element, figure } from './figure';
import { axisIn, count, energyText, givenLength, isNumber, kJ, lengthText, measured, number, resultIn, unitIn } from './format';
import { barriersOf, placeText, runs, single } from './run';
import { statisticsTable } from './statistics';
import { table } from './tables';

function hitFigure(parent, name) {
  const shown = runs.map((run) => ({run, hits: run.hits.filter((hit) => hit.barrier === name)})).filter((s) => s.hits.length);
  if (!shown.length) return;
  const all = shown.flatMap((s) => s.hits.map((hit) => ({...hit, run: s.run})));
  const reached = (run) => (run.barriers.find((b) => b.name === name) || {}).hits;
  figure(parent, {
    title: 'Impact height and translational energy', label: `Impact height against translational energy at ${name}`,
    caption: shown.map((s) => `${single ? '' : s.run.label + ': '}${number(s.hits.length)} of ${number(isNumber(reached(s.run)) ? reached(s.run) : s.hits.length)} hits`).join('; ') + '.',
    draw(svg, width) {
      const side = {left: 62, right: width - 12, top: 12, bottom: 232};
      const walls = runs.flatMap((run) => barriersOf(run).filter((b) => b.name === name && isNumber(b.height_m)));
      const top = d3.max(walls, (b) => b.height_m);
      const toX = d3.scaleLinear().domain(extentOf([0, ...all.map((h) => h.ke_translational)])).range([side.left, side.right]);
      const toY = d3.scaleLinear().domain(extentOf([0, ...(top ? [top] : []), ...all.map((h) => h.height)], 0.05)).range([side.bottom, side.top]);
      axes(svg, axisIn('J', toX), axisIn('m', toY), side, {xLabel: `Translational kinetic energy [${unitIn('J')}]`, yLabel: `Impact height of the contact [${unitIn('m')}]`});
      for (const height of new Set(walls.map((b) => b.height_m))) {
        svg.append('line').attr('class', 'barrier').style('stroke-width', 1.5).attr('x1', side.left).attr('x2', side.right).attr('y1', toY(height)).attr('y2', toY(height));
        svg.append('text').attr('class', 'barrier-name halo').attr('x', side.left + 6).attr('y', toY(height) + 14).text(`top, ${givenLength(height)}`);
      }
      tip(svg.append('g').selectAll('circle').data(all).enter().append('circle').attr('class', 'dot').attr('r', 3.4).style('--run', (h) => h.run.colour)
        .attr('cx', (h) => toX(h.ke_translational)).attr('cy', (h) => toY(h.height)),
      (h) => `Rock ${h.rock}: ${h.outcome}` + (single ? '' : ` · ${h.run.label}`) +
        `\nheight ${lengthText(h.height)}, angle ${measured(h.angle, 3)}°\ntranslational ${energyText(h.ke_translational)}, total ${energyText(h.ke_total)}\nat ${placeText(h.run, h, true)}`);
      return single ? side.bottom + 42 : legend(svg, shown.map((s) => ({text: s.run.label, draw: sign.circle('dot', s.run.colour)})), side.left, side.bottom + 54, side.right) + 12;
    },
    rows: () => [['run', 'rock', 'impact_height_m', 'angle_deg', 'ke_translational_kJ', 'ke_total_kJ', 'outcome'],
      ...all.map((h) => [h.run.label, h.rock, h.height, h.angle, kJ(h.ke_translational), kJ(h.ke_total), h.outcome])],
  });
}

// The number of rocks that the figures of a barrier's hits exclude, and the meaning of a negative clearance.
function passedAboveText(name) {
  const shown = runs.map((run) => ({run, barrier: run.barriers.find((b) => b.name === name) || {}})).filter(({barrier}) => barrier.passed_above > 0);
  const rocks = shown.map(({run, barrier}) => (single ? '' : `${run.label}: `) + count(barrier.passed_above, 'rock')).join(', ');
  const isBelow = shown.some(({barrier}) => barrier.least_clearance_m < 0);
  return `The figures of the hits exclude ${rocks} that passed with the centre above the top. Clearance is measured from the rock's lower side` +
    (isBelow ? '; it is negative if the centre passed above the top and the lower side below it.' : '.');
}

// A collector only records rocks: it has passages instead of hits, and no outcomes.
function countRows(kind, of) {
  const row = (label, value) => [label, ...runs.map((run) => number(value(of(run))))];
  const outcomes = kind === 'collector' ? [] : [...new Set(runs.flatMap((run) => Object.keys(of(run).outcomes || {})))];
  const [hits, rocks] = kind === 'collector' ? ['Passages', 'Rocks that passed'] : ['Hits', 'Rocks that hit'];
  return [
    row(hits, (b) => b.hits),
    ...(runs.some((run) => isNumber(of(run).rocks_hit)) ? [row(rocks, (b) => b.rocks_hit)] : []),
    ...outcomes.map((word) => row(`Hits: ${word}`, (b) => (b.outcomes || {})[word])),
    row('Rocks that passed above', (b) => b.passed_above),
    [{text: 'Minimum clearance above', unit: unitIn('m')}, ...runs.map((run) => resultIn('m', of(run).least_clearance_m, 3))],
  ];
}

export function barrierSections(parent) {
  const names = [...new Set(runs.flatMap((run) => run.barriers.map((b) => b.name)))];
  for (const name of names) {
    const of = (run) => run.barriers.find((b) => b.name === name) || {};
    const kind = runs.map((run) => of(run).kind).find((k) => k) || 'barrier';
    element(parent, 'h3', `${kind.charAt(0).toUpperCase()}${kind.slice(1)}: ${name}`);
    const box = element(parent, 'div', null, {class: 'columns'});
    const facts = element(box, 'div');
    table(facts, {head: [['', ...(single ? ['Number'] : runs.map((run) => ({text: run.label, run})))]], rows: countRows(kind, of), numeric: (column) => column > 0});
    if (runs.some((run) => of(run).passed_above > 0)) element(facts, 'p', passedAboveText(name), {class: 'quiet'});
    hitFigure(box, name);
    histogramFigure(box, {title: 'Translational energy at impact', quantity: 'Translational kinetic energy', column: 'ke_translational_J', unit: 'J', thing: 'hit', of: (run) => (of(run).histograms || {}).ke_translational_J});
    histogramFigure(box, {title: 'Impact height', quantity: 'Impact height of the contact', column: 'impact_height_m', unit: 'm', thing: 'hit', of: (run) => (of(run).histograms || {}).impact_height_m});
    statisticsTable(parent, runs, [
      {text: 'Translational energy', unit: 'J', of: (run) => (of(run).statistics || {}).ke_translational_J},
      {text: 'Total kinetic energy', unit: 'J', of: (run) => (of(run).statistics || {}).ke_total_J},
      {text: 'Impact height (contact)', unit: 'm', of: (run) => (of(run).statistics || {}).impact_height_m},
      {text: 'Velocity', unit: 'm/s', of: (run) => (of(run).statistics || {}).velocity_m_s},
    ], 'Descriptive statistics of the hits');
  }
}
