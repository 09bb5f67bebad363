import type { EChartsOption } from 'echarts/types/dist/shared';
import { useCallback } from 'preact/hooks';
import type { RockAnswer, Run } from '../api/types';
import { numberText } from '../ui/format';
import { Chart } from './Chart';
import { axis, type Look } from './chartLook';
import { tooltipOf } from './distributionPlots';
import { fileName } from './save';

const parts = ['Translational', 'Rotational', 'Potential'] as const;

function plot(energy: RockAnswer['energy'], look: Look): EChartsOption {
  return {
    legend: { top: 0, textStyle: { color: look.text }, itemWidth: 16, itemHeight: 10 },
    grid: { left: 12, right: 18, top: 34, bottom: 8, outerBoundsMode: 'same', outerBoundsContain: 'all' },
    tooltip: {
      ...tooltipOf(look),
      trigger: 'axis',
      valueFormatter: (value: unknown) => `${numberText(Number(value))} kJ`,
    },
    xAxis: { ...axis(look, 'Time [s]'), min: 0 },
    yAxis: { ...axis(look, 'Energy [kJ]'), scale: false },
    // One on the other, so that what is lost shows as a step of their sum.
    series: parts.map((name, k) => ({
      type: 'line',
      name,
      stack: 'energy',
      showSymbol: false,
      lineStyle: { width: 1 },
      areaStyle: { opacity: 0.55 },
      data: energy.map((row) => [row[0], row[k + 1]! / 1000]),
    })),
  } as EChartsOption;
}

/// How a rock's energy changes its form, and where it is lost.
export function RockEnergy({ run, rock, path }: { run: Run; rock: number; path: RockAnswer }) {
  const draw = useCallback((look: Look) => plot(path.energy, look), [path]);
  return (
    <Chart
      title="Energy over time"
      description={`Translational, rotational and potential energy of rock ${rock} over time. The CSV button saves their numbers.`}
      file={fileName(run.name, `rock ${rock} energy`)}
      option={draw}
      rows={() => [['time_s', 'ke_translational_J', 'ke_rotational_J', 'pe_J'], ...path.energy]}
    />
  );
}
