// Results at each barrier and collector: counts, statistics of hits, design percentiles.

import { useMemo, useState } from 'preact/hooks';
import { results, type BarrierAnswer } from '../api/results';
import type { Run } from '../api/types';
import { filter } from '../runs/filter';
import { counted } from '../units/numbers';
import { BarrierCounts } from './BarrierCounts';
import { ColumnChoice, hitChoices } from './ColumnChoice';
import { titleOf } from '../charts/columns';
import { DesignSummary } from './DesignSummary';
import { DesignTable } from './DesignTable';
import { DistributionFigures } from './DistributionFigures';
import type { Layer } from './layers';
import { shownColour } from '../charts/colours';
import { FilterNote } from './FilterNote';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { StatisticsTable } from './StatisticsTable';
import { Waiting } from '../ui/Waiting';

/// The population of the statistics: hits only.
function populationOf({ passed_above }: BarrierAnswer, hits: number): string {
  const above = Number(passed_above);
  if (above === 0) return counted(hits, 'hit');
  const others = `${counted(above, 'rock')} passed above the top and ${above === 1 ? 'is' : 'are'}`;
  return `${counted(hits, 'hit')}; ${others} not included`;
}

function Hits({ run, barrier, number }: { run: Run; barrier: BarrierAnswer; number: number }) {
  const [column, choose] = useState('ke_total_J');
  const now = filter.value;
  const answer = useRemote(`${run.id} ${number}`, `${run.done} ${column} ${JSON.stringify(now)}`, async (signal) => ({
    column,
    statistics: await results.barrierStatistics(run.id, number, column, now, signal),
  }));
  const found = answer.value;
  const layers = useMemo<Layer[]>(
    () => (found ? [{ name: barrier.name, statistics: found.statistics, colour: shownColour }] : []),
    [found, barrier.name],
  );
  return (
    <>
      <div class="tab-tools">
        <ColumnChoice columns={hitChoices} now={column} choose={choose} />
        <FilterNote />
      </div>
      {!found ? (
        <Waiting of={answer} />
      ) : found.statistics.count === 0 ? (
        <p class="faint tab-tools">No rock hit this barrier.</p>
      ) : (
        <div class="figures">
          <DistributionFigures layers={layers} column={found.column} thing="hit" of={`${run.name} ${barrier.name}`} />
          <StatisticsTable
            caption={`Statistics of ${populationOf(barrier, found.statistics.count)}`}
            file={fileName(run.name, barrier.name, found.column, 'statistics')}
            columns={[
              { key: found.column, title: titleOf(found.column), unit: found.statistics.unit, figures: found.statistics.statistics },
            ]}
          />
        </div>
      )}
    </>
  );
}

export function Barriers({ run }: { run: Run }) {
  const [chosen, choose] = useState(0);
  const answer = useRemote(run.id, String(run.done), (signal) => results.barriers(run.id, signal));
  const barriers = answer.value;
  if (!barriers) return <Waiting of={answer} />;
  const barrier = barriers[chosen] ?? barriers[0];
  if (!barrier)
    return <div class="empty">This run had no barriers. Add a barrier or a collector to the model, and compute again.</div>;
  return (
    <div class="tab-page">
      <div class="tab-block">
        <BarrierCounts rows={barriers.map((one) => ({ barrier: one }))} file={run.name} />
      </div>
      <div class="tab-tools">
        <label class="choice">
          Barrier
          <select value={chosen} onChange={(event) => choose(Number(event.currentTarget.value))}>
            {barriers.map(({ name }, k) => (
              <option key={k} value={k}>
                {name}
              </option>
            ))}
          </select>
        </label>
      </div>
      <Hits run={run} barrier={barrier} number={barriers.indexOf(barrier)} />
      <div class="tab-block">
        {barrier.design ? (
          <>
            <DesignTable run={run} name={barrier.name} design={barrier.design} />
            <DesignSummary run={run} />
          </>
        ) : (
          <p class="faint">
            For design percentiles with confidence intervals and the check of a standard, add a barrier design in the
            model and compute again.
          </p>
        )}
      </div>
    </div>
  );
}
