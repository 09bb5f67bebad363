// Histogram, cumulative curve and box plots, drawn from what the server counted. Of several layers, counted in the same
// bins, a histogram shows shares of each, side by side.

import type { EChartsOption } from 'echarts/types/dist/shared';
import type { ColumnStatistics } from '../api/results';
import { numberText } from '../ui/format';
import { axis, withLegend, type Look } from './chartLook';
import { readingOf, withUnit } from './columns';
import { endsAround, type Ends } from './oneValue';
import type { Cell } from './save';

/// The same of one or several things, such as two runs.
export interface Layer {
  name: string;
  statistics: ColumnStatistics;
  /// Of the look's colours.
  colour: (look: Look) => string;
}

export const shownColour = (look: Look) => look.shown;
/// Of two runs beside each other.
export const firstColour = (look: Look) => look.runs.shown;
export const secondColour = (look: Look) => look.runs.compared;

type Rectangle = { api: (k: number) => number };

const several = (layers: readonly Layer[], look: Look): EChartsOption => (layers.length > 1 ? withLegend(look) : {});

const legendEntries = (layers: readonly Layer[], look: Look) =>
  layers.map((layer) => ({ name: layer.name, itemStyle: { color: layer.colour(look) } }));

/// The axis of a quantity.
const quantityAxis = (look: Look, title: string, ends: Ends | null) => ({ ...axis(look, title), ...ends });

const leastWidth = 0.5; // of a bar, pixels
const oneWidth = 6;

/// What a bar shows of a bin.
const heightOf = (count: number, { statistics }: Layer, layers: readonly Layer[]) =>
  layers.length > 1 ? (100 * count) / Math.max(1, statistics.count) : count;

export function histogram(layers: readonly Layer[], title: string, thing: string, look: Look): EChartsOption {
  const { unit, per } = readingOf(layers[0]?.statistics.unit ?? '');
  const common = several(layers, look);
  const ends = endsAround(layers.flatMap(({ statistics }) => statistics.histogram.edges.map((edge) => edge / per)));
  const narrowest = ends ? oneWidth : leastWidth;
  return {
    ...common,
    ...(layers.length > 1 && { legend: { ...(common.legend as object), data: legendEntries(layers, look) } }),
    tooltip: { ...tooltipOf(look), trigger: 'item' },
    xAxis: quantityAxis(look, withUnit(title, unit), ends),
    yAxis:
      layers.length > 1
        ? { ...axis(look, `Share of each run's ${thing.toLowerCase()} [%]`), min: 0 }
        : { ...axis(look, thing), min: 0, minInterval: 1 },
    series: layers.map((layer, place) => {
      const { edges, counts } = layer.statistics.histogram;
      const colour = layer.colour(look);
      return {
        type: 'custom',
        name: layer.name,
        itemStyle: { color: colour },
        encode: { x: [0, 1], y: 2 },
        data: counts.map((count, k) => [edges[k]! / per, edges[k + 1]! / per, heightOf(count, layer, layers), count]),
        renderItem: (_params, api) => {
          const value = api.value as Rectangle['api'];
          const [from, top] = api.coord([value(0), value(2)]) as [number, number];
          const [to, base] = api.coord([value(1), 0]) as [number, number];
          // Its part of the bin.
          const [left, right] = [place, place + 1].map((k) => from + ((to - from) * k) / layers.length) as [number, number];
          const gap = right - left > 4 ? 1 : 0;
          const width = Math.max(right - left - gap, narrowest);
          return {
            type: 'rect',
            shape: { x: ends && layers.length === 1 ? left - width / 2 : left, y: top, width, height: base - top },
            style: { fill: colour, fillOpacity: 0.85, stroke: colour, lineWidth: gap },
          };
        },
        tooltip: {
          formatter: (point: unknown) => {
            const [from, to, height, count] = (point as { value: [number, number, number, number] }).value;
            const share = layers.length > 1 ? ` (${numberText(height, 3)} %)` : '';
            const name = layers.length > 1 ? `${layer.name}\n` : '';
            return `${name}${numberText(from)} to ${numberText(to)} ${unit}\n${count.toLocaleString('en')} ${thing.toLowerCase()}${share}`;
          },
        },
      };
    }),
  } as EChartsOption;
}

export function histogramRows(layers: readonly Layer[], column: string): Cell[][] {
  return [
    ['of', `${column}_from`, `${column}_to`, 'count', 'share_percent'],
    ...layers.flatMap(({ name, statistics: { histogram: found, count: all } }) =>
      found.counts.map((count, k) => [name, found.edges[k]!, found.edges[k + 1]!, count, (100 * count) / all]),
    ),
  ];
}

/// Points of steps, in percent: up from nothing at the least value.
export function cumulativeCurve(points: readonly (readonly [number, number])[], ends: Ends | null): [number, number][] {
  const steps = points.map(([value, share]): [number, number] => [value, share * 100]);
  const first = points[0];
  if (!first) return [];
  const whole: [number, number][] = [[first[0], 0], ...steps];
  return ends ? [[ends.min, 0], ...whole, [ends.max, 100]] : whole;
}

export function cumulative(layers: readonly Layer[], title: string, thing: string, look: Look): EChartsOption {
  const { unit, per } = readingOf(layers[0]?.statistics.unit ?? '');
  const curves = layers.map(({ statistics }) =>
    statistics.cumulative.map(([value, share]) => [value / per, share] as const),
  );
  const ends = endsAround(curves.flatMap((points) => points.map(([value]) => value)));
  return {
    ...several(layers, look),
    tooltip: {
      ...tooltipOf(look),
      trigger: 'axis',
      valueFormatter: (share: unknown) => `${numberText(Number(share))} % at most`,
    },
    xAxis: { ...quantityAxis(look, withUnit(title, unit), ends), axisPointer: { label: { precision: 3 } } },
    yAxis: { ...axis(look, `Share of ${thing.toLowerCase()} [%]`), min: 0, max: 100 },
    series: layers.map((layer, k) => ({
      type: 'line',
      name: layer.name,
      step: 'end',
      showSymbol: false,
      lineStyle: { color: layer.colour(look), width: 2 },
      itemStyle: { color: layer.colour(look) },
      data: cumulativeCurve(curves[k]!, ends),
    })),
  } as EChartsOption;
}

export function cumulativeRows(layers: readonly Layer[], column: string): Cell[][] {
  return [
    ['of', column, 'share'],
    ...layers.flatMap(({ name, statistics }) => statistics.cumulative.map(([value, share]) => [name, value, share])),
  ];
}

/// One box a layer. Whiskers reach as far as the server says; the least and greatest value are dots.
export function boxes(layers: readonly Layer[], title: string, look: Look): EChartsOption {
  const { unit, per } = readingOf(layers[0]?.statistics.unit ?? '');
  const withBox = layers.filter(({ statistics }) => statistics.box);
  const ends = endsAround(withBox.flatMap(({ statistics: { box } }) => [box.least / per, box.most / per]));
  return {
    tooltip: { ...tooltipOf(look), trigger: 'item' },
    xAxis: quantityAxis(look, withUnit(title, unit), ends),
    yAxis: {
      type: 'category',
      inverse: true,
      data: withBox.map(({ name }) => name),
      axisLabel: { color: look.text, width: 130, overflow: 'truncate' },
      axisLine: { lineStyle: { color: look.faint } },
      axisTick: { show: false },
    },
    series: [
      {
        type: 'boxplot',
        boxWidth: [8, 34],
        data: withBox.map(({ statistics: { box }, colour }) => ({
          value: [box.whisker_low, box.q1, box.median, box.q3, box.whisker_high].map((value) => value / per),
          itemStyle: { color: 'transparent', borderColor: colour(look), borderWidth: 1.6 },
        })),
        tooltip: {
          formatter: (point: unknown) => {
            const layer = withBox[(point as { dataIndex: number }).dataIndex]!;
            const { box, count } = layer.statistics;
            const line = (words: string, value: number) => `${words} ${numberText(value / per)} ${unit}`;
            return [
              `${layer.name}: ${count.toLocaleString('en')}`,
              line('greatest', box.most),
              line('upper whisker', box.whisker_high),
              line('third quartile', box.q3),
              line('median', box.median),
              line('first quartile', box.q1),
              line('lower whisker', box.whisker_low),
              line('least', box.least),
            ].join('\n');
          },
        },
      },
      {
        type: 'scatter',
        symbolSize: 5,
        itemStyle: { color: look.faint },
        silent: true,
        data: withBox.flatMap(({ statistics: { box } }, k) => [
          [box.least / per, k],
          [box.most / per, k],
        ]),
      },
    ],
  } as EChartsOption;
}

export function boxRows(layers: readonly Layer[], column: string): Cell[][] {
  const keys = ['least', 'whisker_low', 'q1', 'median', 'q3', 'whisker_high', 'most'] as const;
  return [
    ['of', 'count', ...keys.map((key) => `${column}_${key}`)],
    ...layers
      .filter(({ statistics }) => statistics.box)
      .map(({ name, statistics: { box, count } }) => [name, count, ...keys.map((key) => box[key])]),
  ];
}

export function tooltipOf(look: Look) {
  return {
    renderMode: 'richText' as const,
    confine: true,
    backgroundColor: look.panel,
    borderColor: look.line,
    textStyle: { color: look.text, fontSize: 12, fontFamily: look.font },
  };
}
