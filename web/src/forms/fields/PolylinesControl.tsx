// Closed polylines, one edit table each, which together form the slope.

import { useState } from 'preact/hooks';
import { edit, valueAt } from '../../project/document';
import { problemsAt } from '../../project/model';
import type { Path } from '../../settings/names';
import type { TomlValue } from '../../toml/format';
import { isSame } from '../../toml/differences';
import { counted } from '../../units/numbers';
import { pathText } from '../../project/place';
import { cellsOf, rowEdits } from '../../settings/rows';
import { waitingAt } from '../../project/unfinished';
import { EditTable } from '../../ui/EditTable';
import type { FieldProps } from './fieldProps';
import { tableProps } from './geometry';
import { PolygonPreview } from './PolygonPreview';

const isClosed = (rows: TomlValue[]): boolean =>
  rows.length > 1 && isSame(rows[0], rows.at(-1));

export function PolylinesControl({ path }: FieldProps) {
  const [adding, setAdding] = useState(false);
  const value = valueAt(path);
  const lists = Array.isArray(value) ? value : [];
  const hasNew = adding || lists.length === 0 || waitingAt(pathText([...path, lists.length])).length > 0;
  return (
    <div class="polylines">
      {Array.from({ length: lists.length + (hasNew ? 1 : 0) }, (_, k) => (
        // A new polyline keeps its position when its first vertex adds it to the project.
        <Polyline key={k} path={path} lists={lists} k={k} added={() => setAdding(false)} />
      ))}
      {!hasNew && (
        <button class="button" onClick={() => setAdding(true)}>
          + Add polyline
        </button>
      )}
      {lists.length > 0 && <PolygonPreview polylines={lists} />}
    </div>
  );
}

function Polyline({ path, lists, k, added }: { path: Path; lists: TomlValue[]; k: number; added: () => void }) {
  const given = lists[k];
  const rows = Array.isArray(given) ? given : [];
  const own = [...path, k];
  const [open, setOpen] = useState(lists.length <= 4 || given === undefined || problemsAt(pathText(own)).length > 0);
  const take = (next: TomlValue[][], what: string) => {
    if (given !== undefined) {
      edit(`${what} polyline ${k + 1}`, rowEdits(own, rows, next), what === 'change' ? pathText(own) : '');
    } else if (next.length > 0) {
      added();
      edit(
        `add polyline ${k + 1}`,
        [k === 0 ? { set: path, value: [next] } : { set: own, value: next }],
        pathText(own),
      );
    }
  };
  const remove = () =>
    edit(`delete polyline ${k + 1}`, [lists.length === 1 ? { set: path, value: [] } : { remove: own }]);
  const state =
    given === undefined
      ? 'new: type or paste its vertices; the last equals the first'
      : `${counted(rows.length, 'vertex', 'vertices')}, ${isClosed(rows) ? 'closed' : 'open'}`;
  return (
    <details class="polyline" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        Polyline {k + 1} <span class="faint">{state}</span>
      </summary>
      <EditTable
        label={`Polyline ${k + 1}`}
        columns={['x', 'y', 'z']}
        cells={cellsOf(rows, 3)}
        least={3}
        take={take}
        {...tableProps(own, path)}
      >
        {rows.length > 2 && !isClosed(rows) && (
          <button
            class="button"
            onClick={() => edit(`close polyline ${k + 1}`, [{ set: [...own, rows.length], value: rows[0]! }])}
          >
            Close the polyline
          </button>
        )}
        {given !== undefined && (
          <button class="button danger" aria-label={`Delete polyline ${k + 1}`} onClick={remove}>
            Delete
          </button>
        )}
      </EditTable>
    </details>
  );
}
