import type { EChartsOption } from 'echarts/types/dist/shared';
import { useCallback } from 'preact/hooks';
import type { RockAnswer, Run } from '../api/types';
import { numberText } from '../ui/format';
import { Chart } from './Chart';
import { axis, withLegend, type Look } from './chartLook';
import { tooltipOf } from './distributionPlots';
import { asInFiles } from './columns';
import { fileName } from './save';

const parts = ['Kinetic, translational', 'Kinetic, rotational', 'Potential'] as const;

function plot(energy: RockAnswer['energy'], look: Look): EChartsOption {
  return {
    ...withLegend(look),
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
      description={`Translational and rotational kinetic energy and potential energy of rock ${rock} over time. The CSV button saves their numbers.`}
      file={fileName(run.name, `rock ${rock} energy`)}
      option={draw}
      saving={asInFiles}
      rows={() => [['time_s', 'ke_translational_J', 'ke_rotational_J', 'pe_J'], ...path.energy]}
    />
  );
}
