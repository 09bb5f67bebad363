import { useCallback } from 'preact/hooks';
import { Chart } from './Chart';
import type { Look } from './chartLook';
import { savingOf, titleOf } from './columns';
import { cumulative, cumulativeRows, histogram, histogramRows, type Layer } from './distributionPlots';
import { fileName } from './save';

interface Props {
  layers: readonly Layer[];
  column: string;
  /// What is counted: "Rocks", "Hits".
  thing: string;
  /// Words for the names of saved files.
  of: string;
}

/// The histogram and the cumulative curve of a quantity.
export function DistributionFigures({ layers, column, thing, of }: Props) {
  const title = titleOf(column);
  const drawHistogram = useCallback((look: Look) => histogram(layers, title, thing, look), [layers, title, thing]);
  const drawCumulative = useCallback((look: Look) => cumulative(layers, title, thing, look), [layers, title, thing]);
  const counted = layers.map(({ name, statistics }) => `${name}: ${statistics.count}`).join(', ');
  return (
    <>
      <Chart
        title="Histogram"
        description={`Histogram of ${title.toLowerCase()} over ${thing.toLowerCase()} (${counted}). The CSV button saves its numbers.`}
        file={fileName(of, column, 'histogram')}
        option={drawHistogram}
        saving={savingOf(column)}
        rows={() => histogramRows(layers, column)}
      />
      <Chart
        title="Cumulative"
        description={`Share of ${thing.toLowerCase()} with at most a ${title.toLowerCase()} (${counted}). The CSV button saves its numbers.`}
        file={fileName(of, column, 'cumulative')}
        option={drawCumulative}
        saving={savingOf(column)}
        rows={() => cumulativeRows(layers, column)}
      />
    </>
  );
}
