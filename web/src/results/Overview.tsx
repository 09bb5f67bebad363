// The overview of a run, from summary.json.

import { results, type RockFilter } from '../api/results';
import type { Run } from '../api/types';
import type { NumberText } from '../api/exact';
import { filter, isFiltering } from '../runs/filter';
import { clockText } from '../units/texts';
import { counted, numberText } from '../units/numbers';
import { endpointColumnOf, titleOf, unitOf } from '../charts/columns';
import { EndReasons } from './EndReasons';
import { FilterNote } from './FilterNote';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { StatisticsTable } from './StatisticsTable';
import { Waiting } from '../ui/Waiting';

const order = ['runout_xy_m', 'runout_total_m', 'max_ke_J', 'max_bounce_m', 'time_s'];

/// Statistics of all rocks from summary.json, or of the filtered rocks from the server.
async function overviewOf(run: Run, now: RockFilter, signal: AbortSignal) {
  const summary = await results.summary(run.id, signal);
  const figuresOf = async (column: string, of: RockFilter) => (await results.statistics(run.id, column, of, signal)).statistics;
  if (!isFiltering(now)) {
    const statistics = { ...summary.statistics, time_s: await figuresOf('time_s', now) };
    return { summary, statistics, reasons: summary.end_reasons };
  }
  const columns = [...Object.keys(summary.statistics), 'time_s'];
  const reasons = Object.keys(summary.end_reasons).filter(
    (reason) => Number(summary.end_reasons[reason]) > 0 && (now.reasons?.includes(reason) ?? true),
  );
  const [figures, counts] = await Promise.all([
    Promise.all(columns.map(async (key) => [key, await figuresOf(endpointColumnOf(key), now)] as const)),
    Promise.all(reasons.map(async (reason) => [reason, (await figuresOf('time_s', { ...now, reasons: [reason] })).count as NumberText] as const)),
  ]);
  return { summary, statistics: Object.fromEntries(figures), reasons: Object.fromEntries(counts) };
}

export function Overview({ run }: { run: Run }) {
  const now = filter.value;
  const answer = useRemote(run.id, `${run.state} ${run.done} ${JSON.stringify(now)}`, async (signal) => ({
    ...(await overviewOf(run, now, signal)),
    isOfSome: isFiltering(now),
  }));
  if (!answer.value) return <Waiting of={answer} />;
  const { summary, statistics, reasons, isOfSome } = answer.value;
  const left = Number(statistics.time_s!.count);
  const seconds = Number(summary.timings.seconds);
  const rank = (key: string) => (order.indexOf(key) + order.length + 1) % (order.length + 1);
  const columns = Object.entries(statistics)
    .sort(([a], [b]) => rank(a) - rank(b))
    .map(([key, figures]) => ({ key, title: titleOf(key), unit: unitOf(key), figures }));
  return (
    <div class="overview">
      <div class="facts">
        <FilterNote left={isOfSome ? left : undefined} of={Number(summary.rocks.done)} />
        <EndReasons reasons={reasons} of={left} file={fileName(run.name, 'end reasons')} />
        <dl>
          <dt>Rocks</dt>
          <dd>
            {numberText(Number(summary.rocks.done))}
            {summary.rocks.done !== summary.rocks.planned && ` of ${numberText(Number(summary.rocks.planned))}: the run was stopped`}
          </dd>
          <dt>Impacts, hits and take-offs</dt>
          <dd>{numberText(Number(summary.events))}</dd>
          <dt>Seed</dt>
          <dd>{summary.seed}</dd>
          <dt>Run time</dt>
          <dd>
            {seconds < 60 ? `${numberText(seconds, 3)} s` : clockText(seconds)} on{' '}
            {counted(Number(summary.timings.threads), 'thread')}
          </dd>
        </dl>
        {Number(summary.rocks.lifted) > 0 && (
          <p class="problem warning">{counted(Number(summary.rocks.lifted), 'rock')}
            {' '}had a release below the ground and {summary.rocks.lifted === '1' ? 'was' : 'were'} lifted out of it where
            possible.</p>
        )}
        {(summary.notes ?? []).map((note) => (
          <p key={note} class="faint">
            {note}.
          </p>
        ))}
      </div>
      <StatisticsTable
        caption={`Statistics over ${isOfSome ? `${left.toLocaleString('en')} of ${counted(Number(summary.rocks.done), 'rock')}` : 'all rocks'}`}
        file={fileName(run.name, 'statistics')}
        columns={columns}
      />
    </div>
  );
}
