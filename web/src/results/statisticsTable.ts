// The rows of a table of descriptive statistics.

import type { FigureTexts } from '../api/results';
import type { NumberText } from '../api/exact';

const titles: readonly (readonly [string, string])[] = [
  ['count', 'Count'],
  ['mean', 'Mean'],
  ['standard_error', 'Standard error'],
  ['confidence_level_95', 'Confidence level (95 %)'],
  ['standard_deviation', 'Standard deviation'],
  ['sample_variance', 'Sample variance'],
  ['minimum', 'Minimum'],
  ['quartile_1', 'First quartile'],
  ['median', 'Median'],
  ['quartile_3', 'Third quartile'],
  ['percentile', 'Percentile'],
  ['maximum', 'Maximum'],
  ['range', 'Range'],
  ['skewness', 'Skewness'],
  ['kurtosis', 'Kurtosis'],
  ['sum', 'Sum'],
];

export interface Figure {
  key: string;
  title: string;
}

/// The given statistics in display order.
export function figuresOf(given: FigureTexts): Figure[] {
  return titles.flatMap(([key, title]): Figure[] =>
    key === 'percentile'
      ? Object.keys(given.percentiles ?? {}).map((percent) => ({
          key: `percentile_${percent}`,
          title: `Percentile ${percent}`,
        }))
      : [{ key, title }],
  );
}

/// The unit of a statistic, for a quantity with this unit.
export function unitOfFigure(key: string, unit: string): string {
  if (['count', 'skewness', 'kurtosis'].includes(key)) return '';
  return key === 'sample_variance' && unit ? `${unit}²` : unit;
}

/// '' if it is not given.
export function figureText(given: FigureTexts, key: string): NumberText {
  if (key === 'quartile_1') return given.quartiles?.[0] ?? '';
  if (key === 'quartile_3') return given.quartiles?.[2] ?? '';
  if (key.startsWith('percentile_'))
    return given.percentiles?.[key.slice('percentile_'.length)] ?? '';
  return (given[key] as NumberText | null | undefined) ?? '';
}
