// Observed runouts of the runs of a field experiment, each with the range that was predicted for it.

import { max } from 'd3-array';
import type { PredictedRun } from '../archive/validation';
import { numberText } from '../units/numbers';
import type { Cell } from './files';
import { openDrawing, openPlot, sign, titleOf, type Group, type Room } from './plot';
import { tip } from './tip';

export interface RunRanges {
  /// In the order of the figure.
  runs: readonly PredictedRun[];
  /// Mean runout of the runs that were calibrated on [m].
  others: number;
  /// Lengths are divided by `per` for display in `unit`.
  unit: string;
  per: number;
}

const colours = { observed: 'var(--observed)', predicted: 'var(--accent)', others: 'var(--soft)' };

export function runRanges(element: SVGSVGElement, room: Room, { runs, others, unit, per }: RunRanges) {
  const svg = openDrawing(element, room);
  const most = max(runs, ({ observed, p95 }) => Math.max(observed, p95)) || 1;
  const { side, x, y } = openPlot(svg, room, {
    x: [0, runs.length + 1],
    y: [0, (1.05 * Math.max(most, others)) / per],
    xLabel: 'Run, by observed runout',
    yLabel: titleOf({ title: 'Runout', unit }),
    entries: [
      { text: 'observed', draw: sign.circle('bar', colours.observed) },
      { text: 'predicted, 50 % and 90 %', draw: sign.line('whisker', colours.predicted) },
      { text: 'mean of the other runs', draw: sign.line('whisker', colours.others, '4 3') },
    ],
  });
  svg
    .append('line')
    .attr('class', 'whisker')
    .style('--run', colours.others)
    .style('stroke-dasharray', '4 3')
    .attr('x1', side.left)
    .attr('x2', side.right)
    .attr('y1', y(others / per))
    .attr('y2', y(others / per));
  runs.forEach(({ name, observed, p05, p25, p75, p95 }, k) => {
    const g: Group = svg.append('g');
    const upright = (from: number, to: number, wide: number) =>
      g
        .append('line')
        .attr('class', 'whisker')
        .style('--run', colours.predicted)
        .style('stroke-width', wide)
        .style('stroke-opacity', wide > 2 ? 0.5 : 1)
        .attr('x1', x(k + 1))
        .attr('x2', x(k + 1))
        .attr('y1', y(from / per))
        .attr('y2', y(to / per));
    upright(p05, p95, 1);
    upright(p25, p75, 4);
    g.append('circle')
      .attr('class', 'bar')
      .style('--run', colours.observed)
      .attr('cx', x(k + 1))
      .attr('cy', y(observed / per))
      .attr('r', 2.5);
    const text = (metres: number) => numberText(metres / per, 4);
    const range = (low: number, high: number) => `${text(low)} to ${text(high)} ${unit}`;
    tip(g, () => `${name}: observed ${text(observed)} ${unit}\npredicted, 50 %: ${range(p25, p75)}\n90 %: ${range(p05, p95)}`);
  });
}

export const runRangeRows = ({ runs }: RunRanges): Cell[][] => [
  ['run', 'observed_m', 'p05_m', 'p25_m', 'p75_m', 'p95_m'],
  ...runs.map(({ name, observed, p05, p25, p75, p95 }) => [name, observed, p05, p25, p75, p95]),
];
