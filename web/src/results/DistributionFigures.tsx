import { useCallback } from 'preact/hooks';
import { cumulative, cumulativeRows } from '../figures/cumulative';
import { histogram, histogramRows } from '../figures/histogram';
import type { Room } from '../figures/plot';
import { Chart } from '../charts/Chart';
import { savingOf, titleOf } from '../charts/columns';
import { binsOf, quantityOf, stepsOf, type Layer } from './layers';
import { fileName } from '../charts/save';

interface Props {
  layers: readonly Layer[];
  column: string;
  /// What is counted: "rock" or "hit".
  thing: string;
  /// Words for the names of saved files.
  of: string;
}

/// The histogram and the cumulative distribution of a quantity.
export function DistributionFigures({ layers, column, thing, of }: Props) {
  const title = titleOf(column).toLowerCase();
  const drawHistogram = useCallback(
    (element: SVGSVGElement, room: Room) =>
      histogram(element, room, { ...quantityOf(column, layers), thing, of: binsOf(layers) }),
    [layers, column, thing],
  );
  const drawCumulative = useCallback(
    (element: SVGSVGElement, room: Room) =>
      cumulative(element, room, { ...quantityOf(column, layers), thing, of: stepsOf(layers) }),
    [layers, column, thing],
  );
  const counted = layers.map(({ name, statistics }) => `${name}: ${statistics.count}`).join(', ');
  return (
    <>
      <Chart
        title="Histogram"
        description={`Histogram of ${title} over ${thing}s (${counted}). The CSV button saves its numbers.`}
        file={fileName(of, column, 'histogram')}
        draw={drawHistogram}
        saving={savingOf(column)}
        rows={() => histogramRows(binsOf(layers), column)}
      />
      <Chart
        title="Cumulative"
        description={`Share of ${thing}s up to each ${title} (${counted}). The CSV button saves its numbers.`}
        file={fileName(of, column, 'cumulative')}
        draw={drawCumulative}
        saving={savingOf(column)}
        rows={() => cumulativeRows(stepsOf(layers), column)}
      />
    </>
  );
}
