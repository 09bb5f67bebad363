import type { Summary } from '../api/results';
import { DataTable } from './DataTable';

/// How the rocks of a run ended.
export function EndReasons({ summary, file }: { summary: Summary; file: string }) {
  const done = Number(summary.rocks.done);
  const rows = Object.entries(summary.end_reasons).filter(([, count]) => Number(count) > 0);
  return (
    <div class="end-reasons">
      <DataTable
        caption="How the rocks ended"
        file={file}
        hasHeads
        exact
        columns={[
          { key: 'end_reason', title: 'End', isText: true },
          { key: 'rocks', title: 'Rocks' },
        ]}
        rows={rows}
      />
      <ul class="shares" aria-hidden="true">
        {rows.map(([reason, count]) => (
          <li key={reason} title={reason} style={{ flexGrow: Number(count) / done }} />
        ))}
      </ul>
    </div>
  );
}
