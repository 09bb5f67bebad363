// Histograms and box plots from the summary's counts and quartiles. Two runs have the same bins and are shown side by
// side, as shares of each run.

import { boxes, boxRows, type Box } from '../figures/boxes';
import * as d3 from '../figures/d3';
import { histogram, histogramRows } from '../figures/histogram';
import { endsAround } from '../figures/oneValue';
import type { Group } from '../figures/plot';
import { element, figure } from './figure';
import { count, displayOf, isNumber, number } from './format';
import { runs, single, type Histogram, type Run, type Statistics } from './run';

interface Distribution<Of> {
  title: string;
  /// On the axis.
  quantity: string;
  /// Its name in the saved table.
  column: string;
  /// Of the data.
  unit: string;
  of: (run: Run) => Of | null | undefined;
}

interface HistogramOptions extends Distribution<Histogram> {
  /// What is counted.
  thing?: string;
  tall?: number;
}

/// Returns whether a run has values.
export function histogramFigure(
  parent: Group,
  { title, quantity, column, unit: ofData, of, thing = 'rock', tall = 254 }: HistogramOptions,
): boolean {
  const { unit, per } = displayOf(ofData);
  const series = runs.flatMap((run) => {
    const counted = of(run);
    if (!counted?.counts.some((n) => n > 0)) return [];
    const { low, width, counts } = counted;
    const edges = Array.from({ length: counts.length + 1 }, (_, k) => low + k * width);
    return [{ name: run.label, colour: run.colour, counts, edges, width: width / per }];
  });
  if (series.length === 0) return false;
  const texts = series.map(({ name, counts, edges, width }) => {
    const bins = endsAround(edges) ? 'all values equal' : `bins of ${number(width, 4)} ${unit}`;
    return `${single ? '' : `${name}: `}${count(d3.sum(counts), thing)}, ${bins}`;
  });
  figure(parent, {
    title,
    label: `${title}: histogram of ${quantity} in ${unit}`,
    caption: `${texts.join('; ')}.`,
    tall: tall + (single ? 0 : 24),
    fill: (svg, room) => histogram(svg, room, { title: quantity, unit, per, thing, of: series }),
    rows: () => histogramRows(series, column),
  });
  return true;
}

// Null: the run has too few values.
function boxOf({ label, colour }: Run, statistics: Statistics | null | undefined): Box | null {
  if (!statistics) return null;
  const { quartiles = [], minimum, maximum, mean, count } = statistics;
  const [q1, median, q3] = quartiles;
  if (!isNumber(q1) || !isNumber(median) || !isNumber(q3) || !isNumber(minimum) || !isNumber(maximum)) return null;
  const whiskers = { least: minimum, whisker_low: minimum, whisker_high: maximum, most: maximum };
  return { name: label, colour, count, ...whiskers, q1, median, q3, mean: isNumber(mean) ? mean : null };
}

// Returns whether a run has values.
function boxFigure(parent: Group, { title, quantity, column, unit: ofData, of }: Distribution<Statistics>): boolean {
  const { unit, per } = displayOf(ofData);
  const shown = runs.map((run) => boxOf(run, of(run))).filter((box) => box !== null);
  if (shown.length === 0) return false;
  figure(parent, {
    title,
    label: `${title}: box and whiskers of ${quantity} in ${unit}`,
    caption: '',
    tall: 54 + 56 * shown.length,
    fill: (svg, room) => boxes(svg, room, { title: quantity, unit, per, of: shown }),
    rows: () => boxRows(shown, column),
  });
  return true;
}

// In 3D, x is not a measure of runout.
const inSection =
  <Of>(of: (run: Run) => Of) =>
  (run: Run) =>
    run.isSection ? of(run) : null;

export function distributionFigures(parent: Group) {
  const endX = { quantity: 'x of the end point', column: 'end_x_m', unit: 'm' };
  const runout = { quantity: 'Runout on plan', column: 'runout_xy_m', unit: 'm' };
  const box = element(parent, 'div', null, { class: 'columns' });
  const hasEnds = histogramFigure(box, {
    ...endX,
    title: 'End points of the rocks',
    of: inSection(({ histograms }) => histograms.end_x_m),
  });
  const hasRunout = histogramFigure(box, {
    ...runout,
    title: 'Runout',
    tall: hasEnds ? 254 : 384,
    of: ({ histograms }) => histograms.runout_xy_m,
  });
  // Box plots are below the two histograms of a section, or next to the single one of a terrain.
  const place = hasEnds ? box : element(box, 'div');
  const hasBoxes = [
    boxFigure(place, { ...endX, title: 'Box plot of end points', of: inSection(({ statistics }) => statistics.end_x_m) }),
    boxFigure(place, { ...runout, title: 'Box plot of runout', of: ({ statistics }) => statistics.runout_xy_m }),
    boxFigure(place, {
      title: 'Box plot of maximum energy',
      quantity: 'Maximum total kinetic energy of each rock',
      column: 'max_ke_J',
      unit: 'J',
      of: ({ statistics }) => statistics.max_ke_J,
    }),
    boxFigure(place, {
      title: 'Box plot of maximum bounce height',
      quantity: 'Maximum bounce height of each rock (lowest point)',
      column: 'max_bounce_m',
      unit: 'm',
      of: ({ statistics }) => statistics.max_bounce_m,
    }),
  ].some(Boolean);
  if (!hasEnds && !hasRunout && !hasBoxes) element(parent, 'p', 'The summary has no histograms.', { class: 'quiet' });
}
