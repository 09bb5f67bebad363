// What summary.json says of a run.

import { results } from '../api/results';
import type { Run } from '../api/types';
import { everyRock } from '../state/filter';
import { clockText, counted, numberText } from '../ui/format';
import { titleOf, unitOf } from './columns';
import { EndReasons } from './EndReasons';
import { useRemote } from './remote';
import { fileName } from './save';
import { StatisticsTable } from './StatisticsTable';
import { Waiting } from './Waiting';

const order = ['runout_xy_m', 'runout_total_m', 'max_ke_J', 'max_bounce_m', 'time_s'];

async function overviewOf(run: Run, signal: AbortSignal) {
  const [summary, time] = await Promise.all([
    results.summary(run.id, signal),
    results.statistics(run.id, 'time_s', everyRock, signal),
  ]);
  return { summary, statistics: { ...summary.statistics, time_s: time.statistics } };
}

export function Overview({ run }: { run: Run }) {
  const answer = useRemote(run.id, `${run.state} ${run.done}`, (signal) => overviewOf(run, signal));
  if (!answer.value) return <Waiting of={answer} />;
  const { summary, statistics } = answer.value;
  const seconds = Number(summary.timings.seconds);
  const rank = (key: string) => (order.indexOf(key) + order.length + 1) % (order.length + 1);
  const columns = Object.entries(statistics)
    .sort(([a], [b]) => rank(a) - rank(b))
    .map(([key, figures]) => ({ key, title: titleOf(key), unit: unitOf(key), figures }));
  return (
    <div class="overview">
      <div class="facts">
        <EndReasons summary={summary} file={fileName(run.name, 'end reasons')} />
        <dl>
          <dt>Rocks</dt>
          <dd>
            {summary.rocks.done}
            {summary.rocks.done !== summary.rocks.planned && ` of ${summary.rocks.planned}: the run was stopped`}
          </dd>
          <dt>Impacts and other events</dt>
          <dd>{summary.events}</dd>
          <dt>Seed</dt>
          <dd>{summary.seed}</dd>
          <dt>Time taken</dt>
          <dd>
            {seconds < 60 ? `${numberText(seconds, 3)} s` : clockText(seconds)} on{' '}
            {counted(Number(summary.timings.threads), 'thread')}
          </dd>
        </dl>
        {Number(summary.rocks.lifted) > 0 && (
          <p class="problem warning">{counted(Number(summary.rocks.lifted), 'rock')}
            {summary.rocks.lifted === '1' ? ' was' : ' were'} to start in the ground, and moved out of it where there was
            room.</p>
        )}
        {(summary.notes ?? []).map((note) => (
          <p key={note} class="faint">
            {note}.
          </p>
        ))}
      </div>
      <StatisticsTable caption="Statistics over all rocks" file={fileName(run.name, 'statistics')} columns={columns} />
    </div>
  );
}
