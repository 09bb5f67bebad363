// Figures of a calibration: prior and posterior of a parameter, pairs of parameters, and observed values beside what the
// prior and the posterior predict.

import { max } from 'd3-array';
import { area, line } from 'd3-shape';
import type { Band } from '../archive/calibration';
import { measured, numberText } from '../units/numbers';
import type { Cell } from './files';
import { cumulativeCurve } from './cumulative';
import { extentOf, openDrawing, openPlot, rangeText, readAlong, sign, titleOf, valueText, type Group, type Room } from './plot';
import { tip } from './tip';

interface Named {
  title: string;
  unit: string;
}

/// Shares of the prior and of the posterior in the same bins.
export interface ParameterShares extends Named {
  edges: readonly number[];
  prior: readonly number[];
  posterior: readonly number[];
  /// Quantiles of the posterior: 5, 50 and 95 %.
  quantiles: readonly [number, number, number];
  best: number;
}

const colours = { prior: 'var(--soft)', posterior: 'var(--accent)', observed: 'var(--observed)' };

export function parameterShares(element: SVGSVGElement, room: Room, shown: ParameterShares) {
  const { edges, prior, posterior, quantiles, best, unit } = shown;
  const svg = openDrawing(element, room);
  const highest = Math.max(max(prior) ?? 0, max(posterior) ?? 0);
  const { side, x, y } = openPlot(svg, room, {
    x: [edges[0]!, edges.at(-1)!],
    y: [0, 108 * highest],
    xLabel: titleOf(shown),
    yLabel: 'Share [%]',
    entries: [
      { text: 'prior', draw: sign.box('box', colours.prior) },
      { text: 'posterior', draw: sign.box('bar', colours.posterior) },
      { text: '5, 50, 95 %', draw: sign.line('whisker', colours.posterior, '4 3') },
      { text: 'best set', draw: sign.line('whisker', colours.observed) },
    ],
  });
  const upright = (value: number, colour: string, dash: string) => {
    if (value < edges[0]! || value > edges.at(-1)!) return;
    svg
      .append('line')
      .attr('class', 'whisker')
      .style('--run', colour)
      .style('stroke-dasharray', dash)
      .attr('x1', x(value))
      .attr('x2', x(value))
      .attr('y1', side.top)
      .attr('y2', side.bottom);
  };
  prior.forEach((before, k) => {
    const [left, right] = [x(edges[k]!), x(edges[k + 1]!)];
    const g = svg.append('g') as Group;
    const bar = (share: number, name: string, colour: string) =>
      g
        .append('rect')
        .attr('class', name)
        .style('--run', colour)
        .attr('x', left + 0.5)
        .attr('width', Math.max(1, right - left - 1))
        .attr('y', y(100 * share))
        .attr('height', side.bottom - y(100 * share));
    bar(posterior[k]!, 'bar', colours.posterior);
    bar(before, 'box', colours.prior);
    tip(g, () =>
      [
        rangeText(edges[k]!, edges[k + 1]!, unit),
        `prior ${numberText(100 * before, 3)} %`,
        `posterior ${numberText(100 * posterior[k]!, 3)} %`,
      ].join('\n'),
    );
  });
  quantiles.forEach((value) => upright(value, colours.posterior, '4 3'));
  upright(best, colours.observed, '');
}

export const parameterShareRows = ({ title, edges, prior, posterior }: ParameterShares): Cell[][] => [
  [`${title}_from`, `${title}_to`, 'prior', 'posterior'],
  ...prior.map((share, k) => [edges[k]!, edges[k + 1]!, share, posterior[k]!]),
];

/// Sets of parameters; the area of a dot is the weight of its set.
export interface ParameterPairs {
  x: Named;
  y: Named;
  sets: readonly { x: number; y: number; weight: number }[];
}

export function parameterPairs(element: SVGSVGElement, room: Room, pairs: ParameterPairs) {
  const svg = openDrawing(element, room);
  const heaviest = max(pairs.sets, ({ weight }) => weight) || 1;
  const plot = openPlot(svg, room, {
    x: extentOf(pairs.sets.map(({ x }) => x)),
    y: extentOf(pairs.sets.map(({ y }) => y)),
    xLabel: titleOf(pairs.x),
    yLabel: titleOf(pairs.y),
  });
  for (const { x, y, weight } of pairs.sets) {
    const dot = svg
      .append('circle')
      .attr('class', 'bar')
      .style('--run', colours.posterior)
      .style('fill-opacity', 0.4)
      .style('stroke-opacity', 0.5)
      .attr('cx', plot.x(x))
      .attr('cy', plot.y(y))
      .attr('r', Math.max(0.6, 6 * Math.sqrt(weight / heaviest)));
    tip(dot, () =>
      [`${pairs.x.title} ${valueText(x, pairs.x.unit)}`, `${pairs.y.title} ${valueText(y, pairs.y.unit)}`, `weight ${measured(weight)}`].join('\n'),
    );
  }
}

/// The share of rocks up to each place: observed, and 90 % bands of as many rocks by the prior and by the posterior.
export interface PredictedShares extends Named {
  observed: readonly number[];
  at: readonly number[];
  /// null: none is shown.
  prior: Band | null;
  posterior: Band;
}

export function predictedShares(element: SVGSVGElement, room: Room, shown: PredictedShares) {
  const { at, observed, prior, posterior, unit } = shown;
  const svg = openDrawing(element, room);
  const range: [number, number] = [at[0]!, at.at(-1)!];
  const groups = [0, 1, 2].map(() => svg.append('g') as Group);
  const plot = openPlot(svg, room, {
    x: range,
    y: [0, 100],
    xLabel: titleOf(shown),
    yLabel: 'Share of rocks [%]',
    entries: [
      { text: 'observed', draw: sign.line('step', colours.observed), switches: groups[2]! },
      { text: 'posterior, 90 %', draw: sign.box('box', colours.posterior), switches: groups[1]! },
      ...(prior ? [{ text: 'prior, 90 %', draw: sign.box('box', colours.prior), switches: groups[0]! }] : []),
    ],
  });
  groups.forEach((group) => group.raise());
  const places = at.map((_, k) => k);
  const band = (group: Group, of: Band, colour: string) => {
    const shape = area<number>(
      (k) => plot.x(at[k]!),
      (k) => plot.y(100 * of.low[k]!),
      (k) => plot.y(100 * of.high[k]!),
    );
    group.append('path').attr('class', 'below-curve').style('--run', colour).attr('d', shape(places));
    const middle = line<number>(
      (k) => plot.x(at[k]!),
      (k) => plot.y(100 * of.median[k]!),
    );
    group.append('path').attr('class', 'envelope').style('--run', colour).attr('d', middle(places));
  };
  if (prior) band(groups[0]!, prior, colours.prior);
  band(groups[1]!, posterior, colours.posterior);
  const steps = observed.map((value, k): [number, number] => [value, (k + 1) / observed.length]);
  const corners = cumulativeCurve(steps, range).map(([value, share]) => `${plot.x(value)},${plot.y(share)}`);
  groups[2]!.append('path').attr('class', 'curve').style('--run', colours.observed).attr('d', `M${corners.join('L')}`);
  const percent = (share: number) => `${numberText(100 * share, 3)} %`;
  readAlong(svg, plot, at, (k) =>
    [
      `at most ${valueText(at[k]!, unit)}`,
      `observed: ${percent(observed.filter((value) => value <= at[k]!).length / observed.length)}`,
      `posterior: ${percent(posterior.low[k]!)} to ${percent(posterior.high[k]!)}`,
      ...(prior ? [`prior: ${percent(prior.low[k]!)} to ${percent(prior.high[k]!)}`] : []),
    ].join('\n'),
  );
}

export const predictedShareRows = ({ title, at, prior, posterior }: PredictedShares): Cell[][] => [
  [title, 'posterior_5', 'posterior_50', 'posterior_95', ...(prior ? ['prior_5', 'prior_50', 'prior_95'] : [])],
  ...at.map((place, k) => [
    place,
    posterior.low[k]!,
    posterior.median[k]!,
    posterior.high[k]!,
    ...(prior ? [prior.low[k]!, prior.median[k]!, prior.high[k]!] : []),
  ]),
];
