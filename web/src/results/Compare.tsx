// Two runs laid over each other: how a quantity is distributed in both, and what differs between their projects.

import { useMemo, useState } from 'preact/hooks';
import { results, type ColumnStatistics } from '../api/results';
import type { Run } from '../api/types';
import { RunDifferences } from '../runs/Differences';
import { filter } from '../state/filter';
import { compared, comparedId, hasResults, ownRuns } from '../state/runs';
import { ColumnChoice, endpointColumns } from './ColumnChoice';
import { titleOf } from './columns';
import { DistributionFigures } from './DistributionFigures';
import { comparedColour, shownColour, type Layer } from './distributionPlots';
import { FilterNote } from './FilterNote';
import { useRemote } from './remote';
import { fileName } from './save';
import { SampleNote } from './SampleNote';
import { StatisticsTable } from './StatisticsTable';
import { Waiting } from './Waiting';

/// Two runs of a project often have one name.
const nameOf = (run: Run, other: Run) =>
  run.name === other.name ? `${run.name} (${new Date(run.begun).toLocaleTimeString()})` : run.name;

function Figures({ run, other }: { run: Run; other: Run }) {
  const [column, choose] = useState('runout_xy_m');
  const now = filter.value;
  const answer = useRemote(`${run.id} ${other.id}`, `${run.done} ${other.done} ${column} ${JSON.stringify(now)}`, async (signal) => ({
    column,
    both: (await Promise.all([run, other].map(({ id }) => results.statistics(id, column, now, signal)))) as [
      ColumnStatistics,
      ColumnStatistics,
    ],
  }));
  const found = answer.value;
  const layers = useMemo<Layer[]>(
    () =>
      found
        ? [
            { name: nameOf(run, other), statistics: found.both[0], colour: shownColour },
            { name: nameOf(other, run), statistics: found.both[1], colour: comparedColour },
          ]
        : [],
    [found, run.id, other.id],
  );
  return (
    <>
      <div class="tab-tools">
        <ColumnChoice columns={endpointColumns} now={column} choose={choose} />
        <FilterNote />
        {found?.both.map((statistics, k) => <SampleNote key={k} of={statistics} />)}
      </div>
      {!found ? (
        <Waiting of={answer} />
      ) : (
        <div class="figures">
          <DistributionFigures layers={layers} column={found.column} thing="Rocks" of={`${run.name} ${other.name}`} />
          <StatisticsTable
            caption="Statistics"
            file={fileName(run.name, other.name, found.column, 'statistics')}
            columns={layers.map(({ name, statistics }) => ({
              key: `${found.column} of ${name}`,
              title: `${titleOf(found.column)}: ${name}`,
              unit: statistics.unit,
              figures: statistics.statistics,
            }))}
          />
        </div>
      )}
    </>
  );
}

export function Compare({ run }: { run: Run }) {
  const others = ownRuns.value.filter((one) => one.id !== run.id && hasResults(one));
  const other = compared.value && compared.value.id !== run.id ? compared.value : null;
  if (others.length === 0)
    return <div class="empty">There is no other run of this project. Change something, and compute again.</div>;
  return (
    <div class="tab-page">
      <div class="tab-tools">
        <label class="choice">
          Compare with
          <select value={other?.id ?? ''} onChange={(event) => (comparedId.value = event.currentTarget.value || null)}>
            <option value="">none</option>
            {others.map((one) => (
              <option key={one.id} value={one.id}>
                {nameOf(one, run)}
              </option>
            ))}
          </select>
        </label>
      </div>
      {other && (
        <>
          <Figures run={run} other={other} />
          <div class="tab-block">
            <h3>Settings that differ</h3>
            <RunDifferences run={run} other={other} />
          </div>
        </>
      )}
    </div>
  );
}
