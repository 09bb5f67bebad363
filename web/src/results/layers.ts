// Converts the server's statistics to the data of figures.

import type { ColumnStatistics } from '../api/results';
import type { Bins } from '../figures/histogram';
import type { Box } from '../figures/boxes';
import type { Quantity } from '../figures/plot';
import type { Steps } from '../figures/cumulative';
import { displayOfColumn, titleOf } from '../charts/columns';

/// The statistics of one run or group.
export interface Layer {
  name: string;
  statistics: ColumnStatistics;
  /// A CSS colour.
  colour: string;
}

export function quantityOf(column: string, layers: readonly Layer[]): Quantity {
  return { title: titleOf(column), ...displayOfColumn(column, layers[0]?.statistics.unit) };
}

export const binsOf = (layers: readonly Layer[]): Bins[] =>
  layers.map(({ name, colour, statistics: { histogram } }) => ({ name, colour, ...histogram }));

export const stepsOf = (layers: readonly Layer[]): Steps[] =>
  layers.map(({ name, colour, statistics: { cumulative } }) => ({ name, colour, points: cumulative }));

/// Box plots of the layers that have values.
export const boxesOf = (layers: readonly Layer[]): Box[] =>
  layers
    .filter(({ statistics }) => statistics.box)
    .map(({ name, colour, statistics: { box, count, statistics } }) => ({
      name,
      colour,
      count,
      ...box,
      mean: statistics.mean == null ? null : Number(statistics.mean),
    }));
