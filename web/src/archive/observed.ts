// Observed stops beside simulated ones (src/talus/report/observed_comparison.cpp). All lengths are in metres.

/// A distance between simulated and observed rocks, the median and the 95th percentile of the same by chance, and the
/// share of draws that are as far by chance alone.
export interface ObservedDistance {
  value: number;
  median: number;
  p95: number;
  p_value: number;
}
export interface ObservedFacts {
  mean: number;
  p05: number;
  median: number;
  p95: number;
  /// Values with the share of rocks up to each.
  cumulative: [number, number][];
}
export interface ObservedQuantity {
  key: 'position' | 'x' | 'runout' | 'lateral';
  energy_distance: ObservedDistance;
  /// Of a position on plan missing, as are all below.
  kolmogorov_smirnov?: ObservedDistance;
  simulated?: ObservedFacts;
  observed?: ObservedFacts;
}
export interface ObservedComparison {
  file: string;
  rocks: number;
  draws: number;
  /// How it is measured: "from the mean release"; null: not at all.
  runout: string | null;
  quantities: ObservedQuantity[];
}

export const quantityTitle = ({ key }: ObservedQuantity, { runout }: ObservedComparison) =>
  ({
    position: 'Position on plan',
    x: 'x of the end point',
    runout: `Runout ${runout ?? ''}`,
    lateral: 'Distance beside the line',
  })[key];
