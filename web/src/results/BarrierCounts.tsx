// Counts of rocks at barriers and collectors. Collectors have a separate table, because they stop nothing.

import type { BarrierAnswer } from '../api/results';
import { DataTable, type Column } from '../charts/DataTable';
import { fileName } from '../charts/save';

/// A barrier of a run, with the run's name if there are several.
interface Row {
  barrier: BarrierAnswer;
  run?: string;
}

type Shown = Column & { of: (row: Row) => string };

const text = (key: string, title: string, of: Shown['of']): Shown => ({ key, title, isText: true, of });
const count = (key: keyof BarrierAnswer & string, title: string): Shown => ({
  key,
  title,
  of: ({ barrier }) => String(barrier[key]),
});
const name = text('barrier', 'Name', ({ barrier }) => barrier.name);
const run = text('run', 'Run', (row) => row.run ?? '');
const height: Shown = { key: 'height_m', title: 'Height', unit: 'm', of: ({ barrier }) => barrier.height_m };
const above = count('passed_above', 'Passed above');

const ofBarriers: Shown[] = [
  height,
  { key: 'capacity_kJ', title: 'Capacity', unit: 'kJ', of: ({ barrier }) => barrier.capacity_kJ ?? 'unlimited' },
  count('rocks_hit', 'Rocks that hit'),
  count('stopped', 'Stopped'),
  count('rebounded', 'Rebounded'),
  count('passed_through', 'Passed through'),
  above,
];
const ofCollectors: Shown[] = [height, count('rocks_hit', 'Rocks that passed'), above];

function Counts({ rows, caption, columns, file }: { rows: Row[]; caption: string; columns: Shown[]; file: string }) {
  if (rows.length === 0) return null;
  const shown = [name, ...(rows.some((row) => row.run !== undefined) ? [run] : []), ...columns];
  return (
    <DataTable
      caption={caption}
      file={file}
      hasHeads
      columns={shown}
      rows={rows.map((row) => shown.map(({ of }) => of(row)))}
    />
  );
}

export function BarrierCounts({ rows, file }: { rows: Row[]; file: string }) {
  const of = (kind: BarrierAnswer['kind']) => rows.filter(({ barrier }) => barrier.kind === kind);
  return (
    <>
      <Counts caption="Barriers" rows={of('barrier')} columns={ofBarriers} file={fileName(file, 'barriers')} />
      <Counts caption="Collectors" rows={of('collector')} columns={ofCollectors} file={fileName(file, 'collectors')} />
    </>
  );
}
