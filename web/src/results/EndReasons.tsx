import type { NumberText } from '../api/exact';
import { DataTable } from '../charts/DataTable';

/// The number of rocks for each end reason; `of` is the number of all rocks.
export function EndReasons({ reasons, of, file }: { reasons: Record<string, NumberText>; of: number; file: string }) {
  const rows = Object.entries(reasons).filter(([, count]) => Number(count) > 0);
  return (
    <div class="end-reasons">
      <DataTable
        caption="End reasons"
        file={file}
        hasHeads
        columns={[
          { key: 'end_reason', title: 'End reason', isText: true },
          { key: 'rocks', title: 'Rocks' },
        ]}
        rows={rows}
      />
      <ul class="shares" aria-hidden="true">
        {rows.map(([reason, count]) => (
          <li key={reason} title={reason} style={{ flexGrow: Number(count) / of }} />
        ))}
      </ul>
    </div>
  );
}
