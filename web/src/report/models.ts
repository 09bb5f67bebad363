// The page of a comparison of rock models: figures of each side by side, and the same rocks under all.

import type { ModelComparison, ModelFigure, ModelFigures, ModelVariation, SideView } from '../archive/modelComparison';
import type { Group } from '../figures/plot';
import { rockModelTitle } from '../figures/rockModels';
import { rangesOf, reach, sideView } from '../figures/sideView';
import { embedded } from './data';
import { drawing, element, figure, nameFigures } from './figure';
import { amountIn, count, displayOf, isNumber, measured, number, unitIn } from './format';
import { notes, section, showStudy } from './studyPage';
import { table, type BodyCell } from './tables';

const page = embedded<ModelComparison>();

interface ModelSet {
  model: string;
  figures: ModelFigures;
  changes: ModelVariation['changes'];
}
const sets: readonly ModelSet[] = [
  { model: page.model, figures: page.base, changes: [] },
  ...page.variations.map((each) => ({ model: each.model, figures: each, changes: each.changes })),
];
const isAsked = page.place !== '';
const nameOf = (model: string) => rockModelTitle(model) + (model === page.model ? ' (the project’s)' : '');

// With the shapes that the model gives to blocks.
function titleOf({ model, changes }: ModelSet): string {
  const shapes = new Set(changes.filter(({ path }) => path[2] === 'shape').map(({ after }) => String(after)));
  return nameOf(model) + (shapes.size > 0 ? `, shape ${[...shapes].join(', ')}` : '');
}

interface FigureRow {
  title: string;
  key: ModelFigure;
  text: (value: number) => string;
}
const percentText = (share: number) => `${measured(100 * share, 3)} %`;
const inShown = (unit: string) => (value: number) => `${measured(amountIn(unit, value), 3)} ${unitIn(unit)}`;
const p = `${number(page.percentile)} %`;
const rowsAtPlace: readonly FigureRow[] = [
  { title: page.is_line ? 'Cross' : 'Enter', key: 'share', text: percentText },
  { title: `${p} translational energy`, key: 'ke_translational_J', text: inShown('J') },
  { title: `${p} total energy`, key: 'ke_total_J', text: inShown('J') },
  { title: `${p} ${page.is_line ? 'height of the block’s top' : 'bounce height'}`, key: 'height_m', text: inShown('m') },
  { title: `${p} velocity`, key: 'velocity_m_s', text: inShown('m/s') },
];
const rowsOfFigures: readonly FigureRow[] = [
  ...(isAsked ? rowsAtPlace : []),
  { title: 'Median runout on plan', key: 'runout_median_m', text: inShown('m') },
  { title: `${p} runout on plan`, key: 'runout_m', text: inShown('m') },
  { title: 'Leave the model', key: 'left', text: percentText },
];

function figureCell(figures: ModelFigures, { key, text }: FigureRow): string | BodyCell {
  const [value, low, high] = figures[key] ?? [null, null, null];
  if (value === null) return '–';
  return { text: text(value), below: isNumber(low) && isNumber(high) ? `${text(low)} to ${text(high)}` : null };
}

function figuresTable(parent: Group) {
  const confidence = `${number(100 * page.confidence)} % confidence interval`;
  table(parent, {
    caption: `The same ${count(page.rocks, 'rock')} with each model; below each figure its ${confidence}, of sampling alone`,
    head: [['Figure', ...sets.map(titleOf)]],
    rows: rowsOfFigures.map((row) => [row.title, ...sets.map(({ figures }) => figureCell(figures, row))]),
    numeric: (column) => column > 0,
  });
}

function drawPaths(parent: Group, view: SideView) {
  const { unit, per } = displayOf('m');
  const { s, z } = rangesOf(view);
  const tall = Math.min(460, Math.max(190, 120 + (370 * (z[1] - z[0])) / Math.max(s[1] - s[0], 1e-9)));
  figure(parent, {
    title: 'How far rocks go',
    width: drawing.wide,
    tall: 250,
    caption: 'The share of all rocks that go at least so far from their release, under each model.',
    fill: (node, room) => reach(node, room, { of: view, unit, per }),
    rows: () => [['model', 'runout_m'], ...view.sets.flatMap(({ model, runout_m }) => runout_m.map((runout) => [model, runout]))],
  });
  const columns = element(parent, 'div', null, { class: 'columns' });
  view.sets.forEach(({ model, paths }, which) => {
    const title = nameOf(model);
    figure(columns, {
      title,
      tall,
      label: `Paths of ${paths.length} rocks, ${title}`,
      caption: '',
      fill: (node, room) => sideView(node, room, { of: view, which, unit, per }),
    });
  });
}

const advice = 'No model is right by itself. Choose by observed rocks, or take the worst of the models that cannot be ruled out.';

nameFigures(page.name);
showStudy({
  kind: 'Rock models compared',
  title: page.name || page.project,
  facts: [
    ['Project ', page.project],
    ['At ', isAsked ? page.place : 'no place: only how far rocks go'],
    ['Rocks ', number(page.rocks)],
    ['Seed ', String(page.seed)],
    ['Talus ', page.talus.version],
  ],
  version: page.talus.version,
  warnings: page.warnings,
  metric: 'Sentences about models',
  show: (main) => {
    const view = page.side_view;
    notes(main, 'The models differ by more than chance', page.disagreements);
    section(main, 'Figures', 'figures', figuresTable);
    if (view) section(main, 'The same rocks under each model', 'paths', (node) => drawPaths(node, view));
    element(main, 'p', advice, { class: 'quiet' });
  },
});
