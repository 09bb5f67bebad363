// Box plots of a quantity for all rocks and for each group of rocks.

import { useCallback, useState } from 'preact/hooks';
import { results, type ColumnStatistics, type RockFilter } from '../api/results';
import type { Run } from '../api/types';
import { entriesIn } from '../archive/summary';
import { boxes, boxRows } from '../figures/boxes';
import type { Room } from '../figures/plot';
import { filter } from '../runs/filter';
import { Chart } from '../charts/Chart';
import { savingOf, titleOf } from '../charts/columns';
import { boxesOf, quantityOf, type Layer } from './layers';
import { shownColour } from '../charts/colours';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';

const groupings = {
  none: 'all rocks',
  reasons: 'by end reason',
  seeders: 'by seeder',
  sources: 'by source',
  barriers: 'by barrier hit',
} as const;
type Grouping = keyof typeof groupings;

const mostGroups = 24;

/// The names of the groups, in the run's order.
async function namesOf(run: Run, grouping: Exclude<Grouping, 'none'>, signal: AbortSignal): Promise<string[]> {
  const summary = await results.summary(run.id, signal);
  const names = {
    reasons: () => Object.keys(summary.end_reasons),
    seeders: () => entriesIn(summary.project, 'seeder').map(({ name }, k) => (typeof name === 'string' ? name : `seeder ${k + 1}`)),
    sources: () => summary.sources.map(({ name }) => name),
    barriers: () => (summary.barriers ?? []).map(({ name }) => name),
  }[grouping]();
  return [...new Set(names)].slice(0, mostGroups);
}

async function groupsOf(run: Run, column: string, grouping: Grouping, now: RockFilter, signal: AbortSignal) {
  if (grouping === 'none') return [];
  const chosen = now[grouping];
  const names = (await namesOf(run, grouping, signal)).filter((name) => !chosen || chosen.includes(name));
  return Promise.all(
    names.map(async (name): Promise<Layer> => {
      const one = { ...now, [grouping]: [name] };
      return { name, statistics: await results.statistics(run.id, column, one, signal), colour: shownColour };
    }),
  );
}

export function GroupBoxes({ run, column, all }: { run: Run; column: string; all: ColumnStatistics }) {
  const [grouping, setGrouping] = useState<Grouping>('reasons');
  const now = filter.value;
  const answer = useRemote(run.id, `${run.done} ${column} ${grouping} ${JSON.stringify(now)}`, async (signal) => ({
    column,
    layers: await groupsOf(run, column, grouping, now, signal),
  }));
  const groups = answer.value?.column === column ? answer.value.layers : null;
  const layers: Layer[] = [{ name: 'All', statistics: all, colour: shownColour }, ...(groups ?? [])];
  const title = titleOf(column);
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      boxes(element, room, { ...quantityOf(column, layers), of: boxesOf(layers) }),
    [all, groups, column],
  );
  return (
    <Chart
      title="Box plots"
      description={`Box plots of ${title.toLowerCase()}, ${groupings[grouping]}. The CSV button saves their numbers.`}
      file={fileName(run.name, column, 'boxes')}
      draw={draw}
      saving={savingOf(column)}
      rows={() => boxRows(boxesOf(layers), column)}
      tools={
        <select
          aria-label="Groups of the box plots"
          value={grouping}
          onChange={(event) => setGrouping(event.currentTarget.value as Grouping)}
        >
          {Object.entries(groupings).map(([name, words]) => (
            <option key={name} value={name}>
              {words}
            </option>
          ))}
        </select>
      }
      note={answer.error}
    />
  );
}
