// Tables of settings that differ between two runs, or between a run and the project.

import { results } from '../api/results';
import type { Run } from '../api/types';
import { jsonText } from '../toml/json';
import { useRemote } from '../ui/remote';
import { Waiting } from '../ui/Waiting';

interface Row {
  key: string;
  here?: unknown;
  there?: unknown;
}

const longest = 80;

function valueText(value: unknown): string {
  if (value === undefined || value === null) return '–';
  if (typeof value === 'string') return value;
  const text = typeof value === 'bigint' ? String(value) : jsonText(value);
  return text.length > longest ? `${text.slice(0, longest)}…` : text;
}

/// "material 1, roughness_deg" for "material.0.roughness_deg".
const keyText = (key: string) =>
  key.replace(/\.(\d+)(\.|$)/g, (_all, index: string, end: string) => ` ${Number(index) + 1}${end && ', '}`);

export function DifferenceTable({ rows, here, there }: { rows: readonly Row[]; here: string; there: string }) {
  return (
    <div class="differences">
      <table>
        <thead>
          <tr>
            <th scope="col">Setting</th>
            <th scope="col">{here}</th>
            <th scope="col">{there}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row.key}>
              <th scope="row">{keyText(row.key)}</th>
              <td>{valueText(row.here)}</td>
              <td>{valueText(row.there)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/// The settings that differ between the shown run and the compared one.
export function RunDifferences({ run, other }: { run: Run; other: Run }) {
  const answer = useRemote(`${run.id} ${other.id}`, `${run.state} ${other.state}`, (signal) =>
    results.differences(run.id, other.id, signal),
  );
  if (!answer.value) return <Waiting of={answer} />;
  if (answer.value.length === 0) return <p class="faint">No setting differs.</p>;
  return <DifferenceTable rows={answer.value} here="Shown" there="Compared" />;
}
