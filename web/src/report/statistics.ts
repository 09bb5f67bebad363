// Descriptive statistics: the thirteen rows of a spreadsheet, and percentiles before the maximum.

import type { Group } from '../figures/plot';
import { element } from './figure';
import { displayOf, isNumber, measured, unitIn } from './format';
import type { Run, Statistics } from './run';
import { table, type Row } from './tables';

/// A quantity in the unit of the data, with its statistics of a run.
export interface StatisticsQuantity {
  text: string;
  unit: string;
  of: (run: Run) => Statistics | null | undefined;
}

const percentile = (percent: string) => (of: Statistics) => of.percentiles?.[percent];
const figure = (key: string) => (of: Statistics) => of[key];

// `power`: of the unit.
const statisticsRows: readonly (readonly [label: string, of: (statistics: Statistics) => unknown, power: number])[] = [
  ['Mean', figure('mean'), 1],
  ['Standard error', figure('standard_error'), 1],
  ['Median', figure('median'), 1],
  ['Standard deviation', figure('standard_deviation'), 1],
  ['Sample variance', figure('sample_variance'), 2],
  ['Kurtosis', figure('kurtosis'), 0],
  ['Skewness', figure('skewness'), 0],
  ['Range', figure('range'), 1],
  ['Minimum', figure('minimum'), 1],
  ['Percentile 95', percentile('95'), 1],
  ['Percentile 99', percentile('99'), 1],
  ['Maximum', figure('maximum'), 1],
  ['Sum', figure('sum'), 1],
  ['Count', figure('count'), 0],
  ['Confidence level (95.0 %)', figure('confidence_level_95'), 1],
];

const mostQuantitiesOfTwo = 3; // side by side that fit on paper

/// The quantities that a run has, in several tables if they do not fit into one.
export function statisticsTable(
  parent: Group,
  shown: readonly Run[],
  quantities: readonly StatisticsQuantity[],
  caption: string | null,
) {
  const kept = quantities.filter(({ of }) => shown.some(of));
  if (kept.length === 0) {
    element(parent, 'p', 'The summary has no statistics of these quantities.', { class: 'quiet' });
    return;
  }
  if (shown.length > 1 && kept.length > mostQuantitiesOfTwo) {
    const columns = Math.ceil(kept.length / Math.ceil(kept.length / mostQuantitiesOfTwo));
    for (let from = 0; from < kept.length; from += columns) {
      statisticsTable(parent, shown, kept.slice(from, from + columns), from === 0 ? caption : null);
    }
    return;
  }
  const names = kept.map(({ text, unit }) => ({ text, unit: unitIn(unit), span: shown.length }));
  const runNames = kept.flatMap(() => shown.map((run) => ({ text: run.label, run })));
  const rows = statisticsRows.map(([label, valueOf, power]): Row => {
    const cells = kept.flatMap(({ unit, of }) =>
      shown.map((run) => {
        const statistics = of(run);
        const value = statistics && valueOf(statistics);
        if (!isNumber(value)) return '–';
        const scaled = value / displayOf(unit).per ** power;
        return { text: measured(scaled), full: String(scaled) };
      }),
    );
    return [label, ...cells];
  });
  table(parent, {
    caption,
    head: [['', ...names], ...(shown.length > 1 ? [['', ...runNames]] : [])],
    rows,
    numeric: (column) => column > 0,
  });
}
