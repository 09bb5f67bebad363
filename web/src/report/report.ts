// The page, from top to bottom.

import * as d3 from '../figures/d3';
import type { Group } from '../figures/plot';
import { barrierSections } from './barriers';
import { choice } from './choice';
import { convergenceSections } from './convergence';
import { designSections, designsOf } from './design';
import { distributionFigures } from './distributions';
import { energyFigures } from './energy';
import { envelopeFigures } from './envelopes';
import { factsList } from './facts';
import { factsLine, knownFacts } from './factsLine';
import { drawing, element, nameFigures, unitChoice, unitNote } from './figure';
import { count, isNumber, number, unitSystem } from './format';
import { impactFigure } from './impacts';
import { modelTables } from './inputs';
import { mapFigures } from './maps';
import { observedFigures } from './observed';
import { cards, endReasons, warnings } from './overview';
import { fitTablesToPaper } from './paper';
import { planFigure } from './plan';
import { alike, firstRun, metricParts, page, runs, single, titleBlock, type Run } from './run';
import { sectionFigure } from './sectionFigure';
import { hasForms, shapeSections } from './shapes';
import { setPaper, sheet } from './sheet';
import { statisticsTable, type StatisticsQuantity } from './statistics';
import { clearPage, foot, section } from './studyPage';
import { uncertaintySections } from './uncertainty';

function heading() {
  const head: Group = d3.select('#head');
  unitChoice(head, show);
  element(head, 'p', single ? 'Rockfall analysis' : 'Rockfall analysis · two runs compared', { class: 'kind' });
  element(head, 'h1', single || alike ? firstRun.name : runs.map(({ name }) => name).join(' and '));
  const { client, project, number: numberText, author, checked, revision } = titleBlock;
  const facts = knownFacts([
    ['Client ', client],
    ['Project ', project],
    ['Number ', numberText],
    ['Revision ', revision],
    ['Author ', author],
    ['Checked ', checked],
  ]);
  if (facts.length > 0) factsLine(head, facts);
  factsList(head);
  unitNote(head, metricParts);
}

function slopeFigures(node: Group) {
  const box = element(node, 'div', null, { class: 'columns' });
  sectionFigure(box, planFigure(box) ?? drawing.wide);
}

const rockQuantities: readonly StatisticsQuantity[] = [
  { text: 'End point x', unit: 'm', of: ({ isSection, statistics }) => (isSection ? statistics.end_x_m : null) },
  { text: 'Runout on plan', unit: 'm', of: ({ statistics }) => statistics.runout_xy_m },
  { text: 'Runout in space', unit: 'm', of: ({ statistics }) => statistics.runout_total_m },
  { text: 'Maximum total kinetic energy', unit: 'J', of: ({ statistics }) => statistics.max_ke_J },
  { text: 'Maximum bounce height (lowest point)', unit: 'm', of: ({ statistics }) => statistics.max_bounce_m },
];
const statisticsNote =
  'Standard deviation and variance are sample values (n − 1). Kurtosis is excess kurtosis; skewness is ' +
  'corrected for bias. The confidence level is half the width of the 95 % interval of the mean, by Student’s t. ' +
  'Variances are in the square of the unit. Total kinetic energy is translational plus rotational.';

function runoutFigures(node: Group) {
  distributionFigures(node);
  element(node, 'p', 'Boxes: quartiles and median. Whiskers: minimum and maximum. Cross: mean.', { class: 'quiet' });
  statisticsTable(node, runs, rockQuantities, 'Descriptive statistics, one value per rock');
  element(node, 'p', statisticsNote, { class: 'quiet' });
}

function energies(node: Group) {
  energyFigures(node);
  impactFigure(node);
}

function model(node: Group) {
  if (unitSystem !== 'metric') element(node, 'p', 'Inputs are metric, as in the files of the project.', { class: 'quiet' });
  modelTables(node);
}

/// A part of the page, which is left out if no run has it.
interface Part {
  title: string;
  id: string;
  isIn?: () => boolean;
  fill: (node: Group) => void;
}
const some = (has: (run: Run) => boolean) => () => runs.some(has);
const parts: readonly Part[] = [
  { title: 'Slope and trajectories', id: 'slope', fill: slopeFigures },
  { title: 'Maps', id: 'maps', isIn: some(({ maps }) => maps.length > 0), fill: mapFigures },
  {
    title: 'Envelopes along the section',
    id: 'envelopes',
    isIn: some(({ envelopes }) => envelopes.rows.length > 0),
    fill: envelopeFigures,
  },
  { title: 'End points and runout', id: 'runout', fill: runoutFigures },
  { title: 'Shapes of rocks', id: 'shapes', isIn: some(hasForms), fill: shapeSections },
  { title: 'Observed stops', id: 'observed', isIn: some(({ observed }) => observed !== undefined), fill: observedFigures },
  { title: 'End reasons', id: 'reasons', fill: endReasons },
  { title: 'Barriers and collectors', id: 'barriers', isIn: some(({ barriers }) => barriers.length > 0), fill: barrierSections },
  { title: 'Barrier design', id: 'design', isIn: () => designsOf().length > 0, fill: designSections },
  { title: 'Uncertainty', id: 'uncertainty', isIn: some(({ uncertainty }) => uncertainty.figures.length > 0), fill: uncertaintySections },
  { title: 'Precision', id: 'precision', isIn: some(({ convergence }) => convergence.figures.length > 0), fill: convergenceSections },
  { title: 'Energy', id: 'energy', fill: energies },
  { title: 'Model', id: 'model', fill: model },
];

function speedText({ summary: { timings } }: Run): string[] {
  if (!isNumber(timings?.seconds)) return [];
  const { seconds, rocks_per_second, threads } = timings;
  const speed = isNumber(rocks_per_second) ? `, ${number(Math.round(rocks_per_second))} rocks/s` : '';
  return [`${number(seconds, 3)} s${speed}${isNumber(threads) ? ` on ${count(threads, 'thread')}` : ''}`];
}

// Draws the page, or draws it again in other units.
function show() {
  choice.listeners.length = 0;
  clearPage();
  heading();
  const main: Group = d3.select('#main');
  cards(main);
  warnings(main);
  for (const { title, id, isIn, fill } of parts) if (isIn?.() ?? true) section(main, title, id, fill);
  sheet();
  fitTablesToPaper();
  const speeds = runs.flatMap(speedText).join('; ');
  const folders = runs.map(({ folder }) => folder).join(' and ');
  foot(`${page.version} from the files of ${folders}.${speeds ? ` Run time: ${speeds}.` : ''}`);
}

nameFigures(single ? firstRun.name : '');
setPaper();
show();
