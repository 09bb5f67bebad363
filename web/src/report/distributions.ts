// Histograms and box plots from the summary's counts and quartiles. Two runs have the same bins and are shown side by
// side, as shares of each run.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';
import { element, figure } from './figure';
import { count, displayOf, isNumber, number } from './format';
import { runs, single } from './run';

// `of(run)` returns {low, width, counts} in the data's `unit`; `thing` is what is counted.
export function histogramFigure(parent, {title, quantity, column, unit: ofData, of, thing = 'rock', tall = 254}) {
  const {unit, per} = displayOf(ofData);
  const shown = runs.filter((run) => of(run) && of(run).counts.some((n) => n > 0));
  if (!shown.length) return false;
  const series = shown.map((run) => {
    const {low, width, counts} = of(run);
    return {name: run.label, colour: run.colour, counts, edges: Array.from({length: counts.length + 1}, (_, i) => low + i * width), width: width / per};
  });
  const binText = ({edges, width}) => figures.endsAround(edges) ? 'all values equal' : `bins of ${number(width, 4)} ${unit}`;
  figure(parent, {
    title, label: `${title}: histogram of ${quantity} in ${unit}`,
    caption: series.map((s) => `${single ? '' : s.name + ': '}${count(d3.sum(s.counts), thing)}, ${binText(s)}`).join('; ') + '.',
    tall: tall + (single ? 0 : 24),
    fill: (element, room) => figures.histogram(element, room, {title: quantity, unit, per, thing, of: series}),
    rows: () => figures.histogramRows(series, column),
  });
  return true;
}

// `of(run)` returns statistics with quartiles, minimum, maximum and mean, in the data's `unit`.
function boxFigure(parent, {title, quantity, column, unit: ofData, of}) {
  const {unit, per} = displayOf(ofData);
  const shown = runs.filter((run) => {
    const s = of(run);
    return s && Array.isArray(s.quartiles) && s.quartiles.length === 3 && s.quartiles.every(isNumber) && isNumber(s.minimum) && isNumber(s.maximum);
  });
  if (!shown.length) return false;
  const boxes = shown.map((run) => {
    const {quartiles: [q1, median, q3], minimum, maximum, mean, count} = of(run);
    return {name: run.label, colour: run.colour, count, least: minimum, whisker_low: minimum, q1, median, q3, whisker_high: maximum, most: maximum, mean};
  });
  figure(parent, {
    title, label: `${title}: box and whiskers of ${quantity} in ${unit}`, caption: '',
    tall: 54 + 56 * boxes.length,
    fill: (element, room) => figures.boxes(element, room, {title: quantity, unit, per, of: boxes}),
    rows: () => figures.boxRows(boxes, column),
  });
  return true;
}

export function distributionFigures(parent) {
  const endX = {quantity: 'x of the end point', column: 'end_x_m', unit: 'm'}, runout = {quantity: 'Runout on plan', column: 'runout_xy_m', unit: 'm'};
  const inSection = (of) => (run) => run.isSection ? of(run) : null;  // in 3D, x is not a measure of runout
  const box = element(parent, 'div', null, {class: 'columns'});
  const hasEnds = histogramFigure(box, {...endX, title: 'End points of the rocks', of: inSection((run) => run.histograms.end_x_m)});
  // Box plots are below the two histograms of a section, or next to the single one of a terrain.
  const hasRunout = histogramFigure(box, {...runout, title: 'Runout', tall: hasEnds ? 254 : 384, of: (run) => run.histograms.runout_xy_m});
  const boxes = hasEnds ? box : element(box, 'div');
  const hasBoxes = [
    boxFigure(boxes, {...endX, title: 'Box plot of end points', of: inSection((run) => run.statistics.end_x_m)}),
    boxFigure(boxes, {...runout, title: 'Box plot of runout', of: (run) => run.statistics.runout_xy_m}),
    boxFigure(boxes, {title: 'Box plot of maximum energy', quantity: 'Maximum total kinetic energy of each rock', column: 'max_ke_J', unit: 'J', of: (run) => run.statistics.max_ke_J}),
    boxFigure(boxes, {title: 'Box plot of maximum bounce height', quantity: 'Maximum bounce height of each rock (lowest point)', column: 'max_bounce_m', unit: 'm', of: (run) => run.statistics.max_bounce_m}),
  ].some(Boolean);
  if (!hasEnds && !hasRunout && !hasBoxes) element(parent, 'p', 'The summary has no histograms.', {class: 'quiet'});
}
