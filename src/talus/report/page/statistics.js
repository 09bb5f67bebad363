// Descriptive statistics: the thirteen rows of a spreadsheet, and percentiles beside the greatest value.

// Where a row's value is in the summary's statistics, its words, and which power its unit has.
const statisticsRows = [
  ['mean', 'Mean', 1], ['standard_error', 'Standard error', 1], ['median', 'Median', 1],
  ['standard_deviation', 'Standard deviation', 1], ['sample_variance', 'Sample variance', 2], ['kurtosis', 'Kurtosis', 0],
  ['skewness', 'Skewness', 0], ['range', 'Range', 1], ['minimum', 'Minimum', 1], ['percentiles/95', 'Percentile 95', 1],
  ['percentiles/99', 'Percentile 99', 1], ['maximum', 'Maximum', 1],
  ['sum', 'Sum', 1], ['count', 'Count', 0], ['confidence_level_95', 'Confidence level (95.0 %)', 1],
];

const statistic = (statistics, place) => place.split('/').reduce((node, key) => (node || {})[key], statistics);

// `quantities`: [{text, unit, per, of: (run) => statistics}], where `per` turns the file's unit into the one shown.
function statisticsTable(parent, shown, quantities, caption) {
  const kept = quantities.filter((q) => shown.some((run) => q.of(run)));
  if (!kept.length) return element(parent, 'p', 'The summary holds no statistics of this.', {class: 'quiet'});
  const most = 3;  // of two runs side by side: more would not fit on paper
  if (shown.length > 1 && kept.length > most) {
    const columns = Math.ceil(kept.length / Math.ceil(kept.length / most));
    for (let i = 0; i < kept.length; i += columns) statisticsTable(parent, shown, kept.slice(i, i + columns), i === 0 ? caption : null);
    return null;
  }
  const head = [[''].concat(kept.map((q) => ({text: q.text, unit: q.unit, span: shown.length})))];
  if (shown.length > 1) head.push([''].concat(kept.flatMap(() => shown.map((run) => ({text: run.label, run})))));
  const rows = statisticsRows.map(([place, words, power]) => [words].concat(kept.flatMap((q) => shown.map((run) => {
    const value = statistic(q.of(run), place);
    if (!isNumber(value)) return '–';
    const scaled = value / (q.per || 1) ** power;
    return {text: measured(scaled), full: String(scaled)};
  }))));
  return table(parent, {caption, head, rows, numeric: (column) => column > 0});
}
