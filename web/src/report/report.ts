// The page, from top to bottom.

import * as d3 from '../figures/d3';
import { barrierSections } from './barriers';
import { convergenceSections } from './convergence';
import { designSections, designsOf } from './design';
import { distributionFigures } from './distributions';
import { energyFigures } from './energy';
import { envelopeFigures } from './envelopes';
import { factsLine, factsList } from './facts';
import { drawing, element, nameFigures, unitChoice, unitNote } from './figure';
import { count, isNumber, number, unitSystem } from './format';
import { impactFigure } from './impacts';
import { modelTables } from './inputs';
import { mapFigures } from './maps';
import { observedFigures } from './observed';
import { cards, endReasons, warnings } from './overview';
import { fitTablesToPaper } from './paper';
import { planFigure } from './plan';
import { alike, metricParts, page, runs, single, titleBlock } from './run';
import { hasForms, shapeSections } from './shapes';
import { setPaper, sheet } from './sheet';
import { choice, sectionFigure } from './slope';
import { statisticsTable } from './statistics';
import { uncertaintySections } from './uncertainty';

function heading() {
  const head = d3.select('#head');
  unitChoice(head, show);
  element(head, 'p', single ? 'Rockfall analysis' : 'Rockfall analysis · two runs compared', {class: 'kind'});
  element(head, 'h1', single || alike ? runs[0].name : runs.map((run) => run.name).join(' and '));
  const {client, project, number: numberText, author, checked, revision} = titleBlock;
  const block = [['Client ', client], ['Project ', project], ['Number ', numberText], ['Revision ', revision], ['Author ', author], ['Checked ', checked]].filter(([, value]) => value);
  if (block.length) factsLine(head, block);
  factsList(head);
  unitNote(head, metricParts);
}

function section(title, id, fill) {
  const node = element(d3.select('#main'), 'section', null, {id, 'aria-label': title});
  element(node, 'h2', title);
  fill(node);
  element(d3.select('#contents'), 'a', title, {href: '#' + id});
}

// Draws the page, or draws it again in other units.
function show() {
  choice.listeners.length = 0;
  for (const part of ['#sheet', '#head', '#contents', '#main', '#foot']) d3.select(part).selectAll('*').remove();
  heading();
  cards(d3.select('#main'));
  warnings(d3.select('#main'));
  section('Slope and trajectories', 'slope', (node) => {
    const box = element(node, 'div', null, {class: 'columns'});
    sectionFigure(box, planFigure(box) || drawing.wide);
  });
  if (runs.some((run) => run.maps.length)) section('Maps', 'maps', mapFigures);
  if (runs.some((run) => run.envelopes.rows.length)) section('Envelopes along the section', 'envelopes', envelopeFigures);
  section('End points and runout', 'runout', (node) => {
    distributionFigures(node);
    element(node, 'p', 'Boxes: quartiles and median. Whiskers: minimum and maximum. Cross: mean.', {class: 'quiet'});
    statisticsTable(node, runs, [
      {text: 'End point x', unit: 'm', of: (run) => run.isSection ? run.statistics.end_x_m : null},
      {text: 'Runout on plan', unit: 'm', of: (run) => run.statistics.runout_xy_m},
      {text: 'Runout in space', unit: 'm', of: (run) => run.statistics.runout_total_m},
      {text: 'Maximum total kinetic energy', unit: 'J', of: (run) => run.statistics.max_ke_J},
      {text: 'Maximum bounce height (lowest point)', unit: 'm', of: (run) => run.statistics.max_bounce_m},
    ], 'Descriptive statistics, one value per rock');
    element(node, 'p', 'Standard deviation and variance are sample values (n − 1). Kurtosis is excess kurtosis; skewness is corrected for bias. The confidence level is half the width of the 95 % interval of the mean, by Student’s t. Variances are in the square of the unit. Total kinetic energy is translational plus rotational.', {class: 'quiet'});
  });
  if (runs.some(hasForms)) section('Shapes of rocks', 'shapes', shapeSections);
  if (runs.some((run) => run.observed)) section('Observed stops', 'observed', observedFigures);
  section('End reasons', 'reasons', endReasons);
  if (runs.some((run) => run.barriers.length)) section('Barriers and collectors', 'barriers', barrierSections);
  if (designsOf().length) section('Barrier design', 'design', designSections);
  if (runs.some((run) => run.uncertainty.figures.length)) section('Uncertainty', 'uncertainty', uncertaintySections);
  if (runs.some((run) => run.convergence.figures.length)) section('Precision', 'precision', convergenceSections);
  section('Energy', 'energy', (node) => { energyFigures(node); impactFigure(node); });
  section('Model', 'model', (node) => {
    if (unitSystem !== 'metric') element(node, 'p', 'Inputs are metric, as in the files of the project.', {class: 'quiet'});
    modelTables(node);
  });
  sheet();
  fitTablesToPaper();
  const foot = d3.select('#foot');
  const times = runs.map((run) => run.summary.timings || {}).filter((t) => isNumber(t.seconds));
  const speed = times.map((t) => `${number(t.seconds, 3)} s` + (isNumber(t.rocks_per_second) ? `, ${number(Math.round(t.rocks_per_second))} rocks/s` : '') +
    (isNumber(t.threads) ? ` on ${count(t.threads, 'thread')}` : '')).join('; ');
  element(foot, 'p', `Generated by Talus ${page.version} from the files of ${runs.map((run) => run.folder).join(' and ')}.` + (speed ? ` Run time: ${speed}.` : '') +
    ' This page needs no network. Drawn with D3 (d3js.org), copyright Mike Bostock.');
}

nameFigures(single ? runs[0].name : '');
setPaper();
show();
