// Descriptive statistics: the thirteen rows of a spreadsheet, and percentiles before the maximum.

import { element } from './figure';
import { displayOf, isNumber, measured, unitIn } from './format';
import { table } from './tables';

// [path of the value in the summary's statistics, label, power of the unit]
const statisticsRows = [
  ['mean', 'Mean', 1], ['standard_error', 'Standard error', 1], ['median', 'Median', 1],
  ['standard_deviation', 'Standard deviation', 1], ['sample_variance', 'Sample variance', 2], ['kurtosis', 'Kurtosis', 0],
  ['skewness', 'Skewness', 0], ['range', 'Range', 1], ['minimum', 'Minimum', 1], ['percentiles/95', 'Percentile 95', 1],
  ['percentiles/99', 'Percentile 99', 1], ['maximum', 'Maximum', 1],
  ['sum', 'Sum', 1], ['count', 'Count', 0], ['confidence_level_95', 'Confidence level (95.0 %)', 1],
];

const statistic = (statistics, path) => path.split('/').reduce((node, key) => (node || {})[key], statistics);

// `quantities`: [{text, unit, of: (run) => statistics}] with the units of the data.
export function statisticsTable(parent, shown, quantities, caption) {
  const kept = quantities.filter((q) => shown.some((run) => q.of(run)));
  if (!kept.length) return element(parent, 'p', 'The summary has no statistics of these quantities.', {class: 'quiet'});
  const maximum = 3;  // quantities of two runs side by side that fit on paper
  if (shown.length > 1 && kept.length > maximum) {
    const columns = Math.ceil(kept.length / Math.ceil(kept.length / maximum));
    for (let i = 0; i < kept.length; i += columns) statisticsTable(parent, shown, kept.slice(i, i + columns), i === 0 ? caption : null);
    return null;
  }
  const head = [[''].concat(kept.map((q) => ({text: q.text, unit: unitIn(q.unit), span: shown.length})))];
  if (shown.length > 1) head.push([''].concat(kept.flatMap(() => shown.map((run) => ({text: run.label, run})))));
  const rows = statisticsRows.map(([path, label, power]) => [label].concat(kept.flatMap((q) => shown.map((run) => {
    const value = statistic(q.of(run), path);
    if (!isNumber(value)) return '–';
    const scaled = value / displayOf(q.unit).per ** power;
    return {text: measured(scaled), full: String(scaled)};
  }))));
  return table(parent, {caption, head, rows, numeric: (column) => column > 0});
}
