// Closed polylines, each an edit table; together they are the slope.

import { useState } from 'preact/hooks';
import { edit, valueAt } from '../../state/document';
import { problemsAt } from '../../state/model';
import type { TomlValue } from '../../toml/format';
import { pathText, put } from '../place';
import { cellsOf, rowEdits } from '../rows';
import { EditTable } from './EditTable';
import type { FieldProps } from './Field';
import { PolygonPreview } from './PolygonPreview';

const isClosed = (rows: TomlValue): boolean =>
  Array.isArray(rows) && rows.length > 1 && JSON.stringify(rows[0]) === JSON.stringify(rows.at(-1));

export function PolylinesControl({ field, path }: FieldProps) {
  const [adding, setAdding] = useState(false);
  const value = valueAt(path);
  const lists = Array.isArray(value) ? value : [];
  const remove = (k: number) =>
    lists.length === 1
      ? edit('delete polyline 1', [{ set: path, value: [] }])
      : edit(`delete polyline ${k + 1}`, [{ remove: [...path, k] }]);
  return (
    <div class="polylines">
      {lists.map((rows, k) => {
        const own = [...path, k];
        const problems = problemsAt(pathText(own));
        return (
          <details key={k} class="polyline" open={lists.length <= 4 || problems.length > 0}>
            <summary>
              Polyline {k + 1}{' '}
              <span class="faint">
                {Array.isArray(rows) ? rows.length : 0} vertices{isClosed(rows) ? ', closed' : ', open'}
              </span>
            </summary>
            <EditTable
              label={`Polyline ${k + 1}`}
              columns={['x', 'y', 'z']}
              cells={cellsOf(rows, 3)}
              least={3}
              take={(next, what) =>
                edit(`${what} polyline ${k + 1}`, rowEdits(own, rows, next), what === 'change' ? pathText(own) : '')
              }
            >
              {Array.isArray(rows) && rows.length > 2 && !isClosed(rows) && (
                <button
                  class="button"
                  onClick={() => edit(`close polyline ${k + 1}`, [{ set: [...own, rows.length], value: rows[0]! }])}
                >
                  Close it
                </button>
              )}
              <button class="button danger" aria-label={`Delete polyline ${k + 1}`} onClick={() => remove(k)}>
                Delete
              </button>
            </EditTable>
          </details>
        );
      })}
      {adding || lists.length === 0 ? (
        <details class="polyline" open>
          <summary>
            Polyline {lists.length + 1}{' '}
            <span class="faint">new: type or paste its vertices, the last as the first</span>
          </summary>
          <EditTable
            key={lists.length}
            label={`Polyline ${lists.length + 1}`}
            columns={['x', 'y', 'z']}
            cells={[]}
            least={3}
            take={(next) => {
              if (next.length === 0) return;
              setAdding(false);
              if (lists.length === 0) put(path, [next], field.title, '');
              else edit(`add polyline ${lists.length + 1}`, [{ set: [...path, lists.length], value: next }]);
            }}
          />
        </details>
      ) : (
        <button class="button" onClick={() => setAdding(true)}>
          + Add polyline
        </button>
      )}
      {lists.length > 0 && <PolygonPreview polylines={lists} />}
    </div>
  );
}
