// Shares of deposits by zone: observed, and the range predicted by a calibration.

import { max } from 'd3-array';
import type { CalibratedZone } from '../archive/calibration';
import { numberText } from '../units/numbers';
import type { Cell } from './files';
import { openDrawing, openPlot, sign, type Group, type Room } from './plot';
import { tip } from './tip';
import { shortened } from './tornado';

const colours = { observed: 'var(--soft)', predicted: 'var(--accent)' };
const letterWidth = 6.4;
export const zoneSharesTall = (zones: readonly CalibratedZone[]) => 90 + 26 * zones.length;

export function zoneShares(element: SVGSVGElement, room: Room, zones: readonly CalibratedZone[]) {
  const svg = openDrawing(element, room);
  const names = Math.min(0.5 * room.width, letterWidth * Math.max(1, ...zones.map(({ name }) => name.length)));
  const { side, x } = openPlot(svg, room, {
    x: [0, 106 * (max(zones, (zone) => Math.max(zone.observed_share, zone.predicted_share.p95)) || 1)],
    y: [0, 1],
    xLabel: 'Share of the deposits [%]',
    yLabel: '',
    names: 24 + names,
    entries: [
      { text: 'observed', draw: sign.box('bar', colours.observed) },
      { text: 'predicted: 5, 50, 95 %', draw: sign.line('whisker', colours.predicted) },
    ],
  });
  const each = (side.bottom - side.top) / Math.max(zones.length, 1);
  zones.forEach(({ name, observed_share: observed, predicted_share: { p05: low, p50: median, p95: high } }, k) => {
    const middle = side.top + (k + 0.5) * each;
    const half = Math.min(9, 0.34 * each);
    svg
      .append('text')
      .attr('x', side.left - 10)
      .attr('y', middle + 4)
      .attr('text-anchor', 'end')
      .text(shortened(name, names))
      .append('title')
      .text(name);
    const g: Group = svg.append('g');
    g.append('rect')
      .attr('class', 'bar')
      .style('--run', colours.observed)
      .attr('x', x(0))
      .attr('width', Math.max(x(100 * observed) - x(0), 0.5))
      .attr('y', middle - half)
      .attr('height', 2 * half);
    const whisker = (from: number, to: number, reach: number) =>
      g
        .append('line')
        .attr('class', 'whisker')
        .style('--run', colours.predicted)
        .attr('x1', x(100 * from))
        .attr('x2', x(100 * to))
        .attr('y1', middle - reach)
        .attr('y2', middle + reach);
    whisker(low, high, 0);
    whisker(low, low, half / 2);
    whisker(high, high, half / 2);
    g.append('circle')
      .attr('class', 'bar')
      .style('--run', colours.predicted)
      .attr('cx', x(100 * median))
      .attr('cy', middle)
      .attr('r', 4);
    const percent = (share: number) => `${numberText(100 * share, 3)} %`;
    tip(g, () => `${name}\nobserved ${percent(observed)}\npredicted ${percent(median)} (${percent(low)} to ${percent(high)})`);
  });
}

export const zoneShareRows = (zones: readonly CalibratedZone[]): Cell[][] => [
  ['zone', 'observed', 'predicted_5', 'predicted_50', 'predicted_95'],
  ...zones.map(({ name, observed_share, predicted_share: { p05, p50, p95 } }) => [name, observed_share, p05, p50, p95]),
];
