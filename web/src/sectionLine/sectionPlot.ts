// How a section of the ground is drawn.

import type { EChartsOption } from 'echarts/types/dist/shared';
import type { GroundSection } from '../api/types';
import { axis, type Look, type Size } from '../results/chartLook';
import { tooltipOf } from '../results/distributionPlots';
import type { Cell } from '../results/save';
import { equalRanges } from './groundSection';

/// Around the plot, in pixels, where its size is to be known.
const margin = { left: 74, right: 18, top: 10, bottom: 44 };

export function placeText({ distance_m, z_m, x_m, y_m }: GroundSection, k: number, between = ', '): string {
  const z = z_m[k];
  return [
    `${distance_m[k]!.toFixed(2)} m along`,
    typeof z === 'number' ? `z ${z.toFixed(2)} m` : 'no terrain from here',
    `x ${x_m[k]!.toFixed(2)} y ${y_m[k]!.toFixed(2)} m`,
  ].join(between);
}

export function sectionPlot(section: GroundSection, isEqual: boolean, look: Look, size: Size): EChartsOption {
  const { distance_m, z_m } = section;
  const heights = z_m.filter((z) => z !== null);
  const [low, high] = heights.reduce<[number, number]>(
    ([least, most], z) => [Math.min(least, z), Math.max(most, z)],
    [Infinity, -Infinity],
  );
  const [width, height] = [size.width - margin.left - margin.right, size.height - margin.top - margin.bottom];
  const isFixed = isEqual && heights.length > 0 && width > 0 && height > 0;
  const [along, up] = equalRanges([0, distance_m.at(-1)!], [low, high], Math.max(1, width), Math.max(1, height));
  const fixed = (title: string, [min, max]: [number, number], gap: number) => {
    const made = axis(look, title);
    // Where the axes end is no round number.
    const axisLabel = { ...made.axisLabel, showMinLabel: min === 0, showMaxLabel: false };
    return { ...made, min, max, nameGap: gap, axisLabel };
  };
  const [xTitle, zTitle] = ['Distance along the line [m]', 'Elevation [m]'];
  return {
    ...(isFixed && { grid: margin }),
    tooltip: {
      ...tooltipOf(look),
      trigger: 'axis',
      formatter: (points: unknown) => {
        const k = (points as { dataIndex: number }[])[0]?.dataIndex;
        return k === undefined ? '' : placeText(section, k, '\n');
      },
    },
    xAxis: isFixed ? fixed(xTitle, along, 26) : { ...axis(look, xTitle), min: 0, max: distance_m.at(-1) },
    yAxis: isFixed ? fixed(zTitle, up, 54) : axis(look, zTitle),
    series: [
      {
        type: 'line',
        showSymbol: false,
        lineStyle: { width: 1.6, color: look.shown },
        itemStyle: { color: look.shown },
        areaStyle: { color: look.shown, opacity: 0.14, origin: 'start' },
        // Where there is no terrain the line has a gap.
        data: distance_m.map((distance, k) => [distance, z_m[k] ?? '-']),
      },
    ],
  } as EChartsOption;
}

/// With the engine's digits; an empty elevation: no terrain from there to the next place.
export function sectionRows({ distance_m, z_m, x_m, y_m }: GroundSection): Cell[][] {
  return [
    ['distance_m', 'z_m', 'x_m', 'y_m'],
    ...distance_m.map((distance, k) => [distance, z_m[k] ?? '', x_m[k]!, y_m[k]!]),
  ];
}
