// Compares two runs: distributions of a quantity, barriers, and the settings that differ.

import type { ComponentChildren } from 'preact';
import { useCallback, useMemo, useState } from 'preact/hooks';
import { results, type BarrierAnswer, type ColumnStatistics } from '../api/results';
import type { Run } from '../api/types';
import { boxes, boxRows } from '../figures/boxes';
import type { Room } from '../figures/plot';
import { RunDifferences } from '../runList/Differences';
import { filter } from '../runs/filter';
import { compared, compareWith, hasResults, ownRuns } from '../runs/runs';
import { Chart } from '../charts/Chart';
import { ColumnChoice, endpointChoices, hitChoices } from './ColumnChoice';
import { displayOfColumn, savingOf, titleOf, withUnit } from '../charts/columns';
import { BarrierCounts } from './BarrierCounts';
import { DistributionFigures } from './DistributionFigures';
import { boxesOf, quantityOf, type Layer } from './layers';
import { firstColour, secondColour } from '../charts/colours';
import { FilterNote } from './FilterNote';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { SampleNote } from './SampleNote';
import { StatisticsTable } from './StatisticsTable';
import { Waiting } from '../ui/Waiting';

/// A unique name: runs of a project often have the same name, and may even start in the same second.
function nameOf(run: Run, other: Run): string {
  if (run.name !== other.name) return run.name;
  const [own, others] = [run, other].map(({ begun }) => new Date(begun).toLocaleTimeString());
  return `${run.name} (${own === others ? run.id : own})`;
}

interface Pair {
  run: Run;
  other: Run;
}

function Boxes({ layers, column, of }: { layers: readonly Layer[]; column: string; of: string }) {
  const title = titleOf(column);
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      boxes(element, room, { ...quantityOf(column, layers), of: boxesOf(layers) }),
    [layers, column],
  );
  return (
    <Chart
      title="Box plots"
      description={`Box plots of ${title.toLowerCase()} of both runs. The CSV button saves their numbers.`}
      file={fileName(of, column, 'boxes')}
      draw={draw}
      saving={savingOf(column)}
      rows={() => boxRows(boxesOf(layers), column)}
    />
  );
}

/// A quantity of the rocks, or of the hits on a barrier.
interface FiguresProps extends Pair {
  columns: readonly string[];
  thing: string;
  barrier: string | null;
  /// Further choices before the quantity.
  tools: ComponentChildren;
}

function Figures({ run, other, columns, thing, barrier, tools }: FiguresProps) {
  const [column, choose] = useState(columns[0]!);
  const now = filter.value;
  const answer = useRemote(
    `${run.id} ${other.id} ${barrier}`,
    `${run.done} ${other.done} ${column} ${JSON.stringify(now)}`,
    async (signal) => ({ column, both: await results.compared(run.id, other.id, column, now, barrier, signal) }),
  );
  const found = answer.value;
  const layers = useMemo<Layer[]>(() => {
    const layer = (name: string, statistics: ColumnStatistics, colour: Layer['colour']) => ({ name, statistics, colour });
    if (!found) return [];
    return [layer(nameOf(run, other), found.both[0], firstColour), layer(nameOf(other, run), found.both[1], secondColour)];
  }, [found, run.id, other.id]);
  const of = [run.name, other.name, barrier].filter(Boolean).join(' ');
  return (
    <>
      <div class="tab-tools">
        {tools}
        <ColumnChoice columns={columns} now={column} choose={choose} />
        <FilterNote />
        {found?.both.map((statistics, k) => <SampleNote key={k} of={statistics} />)}
      </div>
      {!found ? (
        <Waiting of={answer} />
      ) : layers.every(({ statistics }) => statistics.count === 0) ? (
        <div class="empty">No {thing}s in either run.</div>
      ) : (
        <div class="figures">
          <DistributionFigures layers={layers} column={found.column} thing={thing} of={of} />
          <Boxes layers={layers} column={found.column} of={of} />
          <div class="across">
            <StatisticsTable
              caption={`Statistics: ${withUnit(titleOf(found.column), displayOfColumn(found.column).unit)}`}
              file={fileName(of, found.column, 'statistics')}
              columns={layers.map(({ name, statistics }) => ({
                key: `${found.column} of ${name}`,
                quantity: found.column,
                title: name,
                unit: statistics.unit,
                figures: statistics.statistics,
              }))}
            />
          </div>
        </div>
      )}
    </>
  );
}

/// Results at the barriers of either run.
function ComparedBarriers({ run, other }: Pair) {
  const [chosen, choose] = useState<string | null>(null);
  const answer = useRemote(`${run.id} ${other.id}`, `${run.done} ${other.done}`, (signal) =>
    Promise.all([results.barriers(run.id, signal), results.barriers(other.id, signal)]),
  );
  if (!answer.value) return <Waiting of={answer} />;
  const [here, there] = answer.value;
  const names = [...new Set([...here, ...there].map(({ name }) => name))];
  if (names.length === 0) return null;
  const name = chosen !== null && names.includes(chosen) ? chosen : names[0]!;
  const rowsOf = (list: BarrierAnswer[], of: string) => (barrier: string) =>
    list.filter((one) => one.name === barrier).map((one) => ({ barrier: one, run: of }));
  const rows = names.flatMap((barrier) => [
    ...rowsOf(here, nameOf(run, other))(barrier),
    ...rowsOf(there, nameOf(other, run))(barrier),
  ]);
  return (
    <section aria-label="Barriers and collectors of both runs">
      <div class="tab-block">
        <BarrierCounts rows={rows} file={fileName(run.name, other.name)} />
      </div>
      <Figures
        key={name}
        run={run}
        other={other}
        columns={hitChoices}
        thing="hit"
        barrier={name}
        tools={
          <label class="choice">
            Hits on
            <select value={name} onChange={(event) => choose(event.currentTarget.value)}>
              {names.map((one) => (
                <option key={one} value={one}>
                  {one}
                </option>
              ))}
            </select>
          </label>
        }
      />
    </section>
  );
}

export function Compare({ run }: { run: Run }) {
  const others = ownRuns.value.filter((one) => one.id !== run.id && hasResults(one));
  const other = compared.value && compared.value.id !== run.id ? compared.value : null;
  if (others.length === 0)
    return <div class="empty">There is no other run of this project. Change something, and compute again.</div>;
  const choice = (
    <label class="choice">
      Compare with
      <select value={other?.id ?? ''} onChange={(event) => compareWith(event.currentTarget.value || null)}>
        <option value="">none</option>
        {others.map((one) => (
          <option key={one.id} value={one.id}>
            {nameOf(one, run)}
          </option>
        ))}
      </select>
    </label>
  );
  return (
    <div class="tab-page">
      {other ? (
        <>
          <Figures run={run} other={other} columns={endpointChoices} thing="rock" barrier={null} tools={choice} />
          <ComparedBarriers run={run} other={other} />
          <div class="tab-block">
            <h3>Settings that differ</h3>
            <RunDifferences run={run} other={other} />
          </div>
        </>
      ) : (
        <div class="tab-tools">{choice}</div>
      )}
    </div>
  );
}
