// The distribution of a quantity over the rocks that pass the filter.

import { useMemo, useState } from 'preact/hooks';
import { results } from '../api/results';
import type { Run } from '../api/types';
import { filter, isFiltering } from '../runs/filter';
import { counted } from '../units/numbers';
import { ColumnChoice, endpointChoices } from './ColumnChoice';
import { titleOf } from '../charts/columns';
import { DistributionFigures } from './DistributionFigures';
import type { Layer } from './layers';
import { shownColour } from '../charts/colours';
import { FilterNote } from './FilterNote';
import { GroupBoxes } from './GroupBoxes';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { SampleNote } from './SampleNote';
import { StatisticsTable } from './StatisticsTable';
import { Waiting } from '../ui/Waiting';

export function Distributions({ run }: { run: Run }) {
  const [column, choose] = useState('runout_xy_m');
  const now = filter.value;
  const answer = useRemote(run.id, `${run.done} ${column} ${JSON.stringify(now)}`, async (signal) => ({
    column,
    statistics: await results.statistics(run.id, column, now, signal),
  }));
  const found = answer.value;
  const layers = useMemo<Layer[]>(
    () => (found ? [{ name: run.name, statistics: found.statistics, colour: shownColour }] : []),
    [found, run.name],
  );
  return (
    <div class="tab-page">
      <div class="tab-tools">
        <ColumnChoice columns={endpointChoices} now={column} choose={choose} />
        <FilterNote left={found?.statistics.count} of={run.done} />
        {found && <SampleNote of={found.statistics} />}
        {found && !isFiltering(now) && <span class="faint">{counted(found.statistics.count, 'rock')}</span>}
      </div>
      {!found ? (
        <Waiting of={answer} />
      ) : found.statistics.count === 0 ? (
        <div class="empty">No rock of this run passes the filter.</div>
      ) : (
        <div class="figures">
          <DistributionFigures layers={layers} column={found.column} thing="rock" of={run.name} />
          <GroupBoxes run={run} column={found.column} all={found.statistics} />
          <StatisticsTable
            caption="Statistics"
            file={fileName(run.name, found.column, 'statistics')}
            columns={[
              {
                key: found.column,
                title: titleOf(found.column),
                unit: found.statistics.unit,
                figures: found.statistics.statistics,
              },
            ]}
          />
        </div>
      )}
    </div>
  );
}
