// What a run in progress has found so far.

import type { Run } from '../api/types';
import { shownPaths, type CountSoFar } from '../paths/drawnPaths';
import { counted, numberText } from '../units/numbers';
import { DataTable } from '../charts/DataTable';
import { fileName } from '../charts/save';

const percent = (share: number) => numberText(100 * share, 3);

function Shares({ run, title, first, counts, confidence }: { run: Run; title: string; first: string; counts: CountSoFar[]; confidence: number }) {
  return (
    <DataTable
      caption={title}
      file={fileName(run.name, `${title.toLowerCase()} so far`)}
      hasHeads
      exact
      columns={[
        { key: 'name', title: first, isText: true },
        { key: 'rocks', title: 'Rocks' },
        { key: 'share', title: 'Share', unit: '%' },
        { key: 'low', title: `${100 * confidence} % interval: from`, unit: '%' },
        { key: 'high', title: 'to', unit: '%' },
      ]}
      rows={counts.map(({ name, rocks, share }) => [name, String(rocks), ...(share ?? []).map(percent)])}
    />
  );
}

export function SoFarTab({ run }: { run: Run }) {
  const of = shownPaths.value?.run === run.id ? shownPaths.value.header.so_far : undefined;
  if (!of) return <div class="empty">The run is in progress. What it has found appears here within seconds.</div>;
  return (
    <div class="so-far">
      <p class="problem warning" role="status">
        In progress: the first {of.done.toLocaleString('en')} of {counted(of.planned, 'rock')}. Rocks are simulated seeder by
        seeder, so these shares may differ from the final ones by more than their intervals. Statistics, maps and tables
        follow when the run finishes or is stopped.
      </p>
      <div class="so-far-tables">
        <Shares run={run} title="End reasons" first="End reason" counts={of.end_reasons} confidence={of.confidence} />
        {of.rocks_hit.length > 0 && (
          <Shares run={run} title="Rocks that hit barriers" first="Barrier or collector" counts={of.rocks_hit} confidence={of.confidence} />
        )}
      </div>
    </div>
  );
}
