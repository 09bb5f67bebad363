// How high, how fast and with how much energy rocks come along a section.

import type { EChartsOption } from 'echarts/types/dist/shared';
import { useCallback, useMemo, useState } from 'preact/hooks';
import { results } from '../api/results';
import type { Run } from '../api/types';
import { numberText } from '../ui/format';
import { Chart } from './Chart';
import { axis, withLegend, type Look } from './chartLook';
import { asInFiles, withUnit } from './columns';
import { tooltipOf } from './distributionPlots';
import { envelopesOf, quantitiesOf, type Envelopes, type Quantity } from './envelopes';
import { useRemote } from './remote';
import { fileName, type Cell } from './save';
import { Waiting } from './Waiting';

const titleOf = ({ title, unit }: Quantity) => withUnit(title, unit);

function plot({ x, columns }: Envelopes, quantity: Quantity, look: Look): EChartsOption {
  return {
    ...withLegend(look),
    tooltip: {
      ...tooltipOf(look),
      trigger: 'axis',
      valueFormatter: (value: unknown) => `${numberText(Number(value))} ${quantity.unit}`,
    },
    xAxis: axis(look, 'x [m]'),
    yAxis: { ...axis(look, titleOf(quantity)), min: 0 },
    // A cell has one value.
    series: quantity.figures.map(({ column, title }) => ({
      type: 'line',
      name: title,
      step: 'middle',
      showSymbol: false,
      lineStyle: { width: 1.5 },
      data: x.map((at, k) => [at, columns.get(column)?.[k] == null ? null : columns.get(column)![k]! / quantity.per]),
    })),
  } as EChartsOption;
}

function rowsOf({ x, columns }: Envelopes, quantity: Quantity): Cell[][] {
  const names = quantity.figures.map(({ column }) => column);
  return [['x_m', ...names], ...x.map((at, k) => [at, ...names.map((name) => columns.get(name)?.[k] ?? '')])];
}

export function EnvelopesTab({ run }: { run: Run }) {
  const answer = useRemote(run.id, `${run.state} ${run.done}`, (signal) => results.fileText(run.id, 'envelopes.csv', signal));
  const [chosen, choose] = useState('energy_total');
  const envelopes = useMemo(() => envelopesOf(answer.value ?? ''), [answer.value]);
  const quantities = useMemo(() => quantitiesOf(envelopes), [envelopes]);
  const quantity = quantities.find(({ key }) => key === chosen) ?? quantities[0];
  const draw = useCallback(
    (look: Look) => (quantity ? plot(envelopes, quantity, look) : {}),
    [envelopes, quantity],
  );
  if (answer.value === null) return <Waiting of={answer} />;
  if (!quantity || envelopes.x.length === 0) return <div class="empty">No rock went anywhere.</div>;
  return (
    <div class="tab-block">
      <Chart
        title="Along the section"
        description={`${titleOf(quantity)} in cells along the section. The CSV button saves the numbers.`}
        file={fileName(run.name, `envelope ${quantity.key}`)}
        option={draw}
        saving={quantity.unit === 'kJ' ? asInFiles : undefined}
        rows={() => rowsOf(envelopes, quantity)}
        tools={
          <select
            aria-label="What is drawn along the section"
            value={quantity.key}
            onChange={(event) => choose(event.currentTarget.value)}
          >
            {quantities.map((each) => (
              <option key={each.key} value={each.key}>
                {titleOf(each)}
              </option>
            ))}
          </select>
        }
      />
    </div>
  );
}
