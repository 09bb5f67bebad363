// Controls of settings that are points: one, rows of them, lists of rows.

import { useState } from 'preact/hooks';
import { edit, valueAt } from '../../state/document';
import { problemsAt } from '../../state/model';
import type { TomlValue } from '../../toml/format';
import { is2d, pathText, put, tableAt, thingOf } from '../place';
import { absentText } from '../words';
import { cellsOf, rowEdits, rowsValue } from '../rows';
import { DrawButton } from './DrawButton';
import { EditTable } from './EditTable';
import { idOf, type FieldProps } from './Field';
import { TypedInput } from './TypedInput';

/// What the columns of a setting's rows are.
function columnsOf({ field, path }: FieldProps): string[] {
  if (path[0] === 'terrain') {
    if (field.key === 'section' || field.key === 'section_std_dev_m') return ['x', 'z'];
    if (field.key === 'triangles') return ['first', 'second', 'third'];
    return ['x', 'y', 'z'];
  }
  if (field.key === 'polygon') return ['x', 'y'];
  return is2d.value ? ['x', 'z'] : ['x', 'y', 'z'];
}

/// How many numbers a position has at the least: its height may be left out where `height_above_m` says it.
function leastOf({ field, path }: FieldProps, columns: number): number {
  const words = 'words' in field.type ? field.type.words : [];
  const mayBeLeftOut = words.includes('surface') && tableAt(path.slice(0, 2)).height_above_m !== undefined;
  return mayBeLeftOut ? columns - 1 : columns;
}

export function TupleControl({ field, path }: FieldProps) {
  const columns = columnsOf({ field, path });
  const value = valueAt(path);
  const [draft, setDraft] = useState<{ cells: string[]; over: string } | null>(null);
  const over = JSON.stringify(value);
  const given = cellsOf(value === undefined ? [] : [value], columns.length)[0];
  const blank = Array<string>(columns.length).fill('');
  const cells = draft && draft.over === over ? draft.cells : (given ?? blank);
  const defaults = Array.isArray(field.default) ? field.default : [];
  const words = 'words' in field.type ? field.type.words : [];
  const invalid = value !== undefined && problemsAt(pathText(path)).some(({ severity }) => severity === 'error');
  const take = (column: number, next: TomlValue | undefined) => {
    const changed = cells.with(column, next === undefined ? '' : String(next));
    if (changed.every((cell) => cell === '')) {
      setDraft(null);
      return put(path, undefined, field.title);
    }
    const rows = rowsValue([changed], leastOf({ field, path }, columns.length));
    setDraft(rows ? null : { cells: changed, over });
    if (rows) put(path, rows[0], field.title);
  };
  return (
    <>
      <div class="tuple">
        {columns.map((column, k) => (
          <label key={column}>
            <span class="faint">{column}</span>
            <TypedInput
              id={k === 0 ? idOf(path) : undefined}
              label={`${field.title}, ${column}`}
              invalid={invalid}
              value={cells[k] === '' ? undefined : cells[k]}
              placeholder={defaults.length > 0 ? String(defaults[columns.length === 2 && k === 1 ? 2 : k] ?? '') : ''}
              words={column === 'z' && words.length > 0 ? `${idOf(path)}-words` : undefined}
              take={(next) => take(k, next)}
            />
          </label>
        ))}
      </div>
      <div class="row">
        <DrawButton path={path} />
      </div>
      {words.length > 0 && (
        <datalist id={`${idOf(path)}-words`}>
          {words.map((word) => (
            <option key={word} value={word} />
          ))}
        </datalist>
      )}
      {draft && draft.over === over && (
        <p class="faint">Taken when {columns.filter((_, k) => cells[k] === '').join(' and ')} is given, too.</p>
      )}
    </>
  );
}

export function RowsControl({ field, path }: FieldProps) {
  const columns = columnsOf({ field, path });
  const value = valueAt(path);
  const take = (rows: TomlValue[][], what: string) => {
    if (rows.length === 0 && field.key !== 'section') return put(path, undefined, field.title);
    edit(
      `${what} ${field.title.toLowerCase()} of ${thingOf(path)}`,
      rowEdits(path, value, rows),
      what === 'change' ? pathText(path) : '',
    );
  };
  return (
    <>
      {value === undefined && absentText(field) && <p class="faint">{absentText(field)}</p>}
      <EditTable
        label={field.title}
        columns={columns}
        cells={cellsOf(value, columns.length)}
        least={leastOf({ field, path }, columns.length)}
        take={take}
      >
        <DrawButton path={path} />
      </EditTable>
    </>
  );
}

/// x of a barrier in 2D, its line on plan in 3D.
export function LineControl({ field, path }: FieldProps) {
  const value = valueAt(path);
  if (is2d.value && (value === undefined || !Array.isArray(value)))
    return (
      <div class="tuple">
        <label>
          <span class="faint">x</span>
          <TypedInput
            id={idOf(path)}
            label={`${field.title}, x`}
            value={value}
            placeholder="x"
            take={(next) => put(path, next, field.title)}
          />
        </label>
        <DrawButton path={path} />
      </div>
    );
  const take = (rows: TomlValue[][], what: string) =>
    rows.length === 0
      ? put(path, undefined, field.title)
      : edit(
          `${what} ${field.title.toLowerCase()} of ${thingOf(path)}`,
          rowEdits(path, value, rows),
          what === 'change' ? pathText(path) : '',
        );
  return (
    <EditTable
      label={field.title}
      columns={['x', 'y']}
      cells={cellsOf(Array.isArray(value) ? value : [], 2)}
      least={2}
      take={take}
    >
      <DrawButton path={path} />
    </EditTable>
  );
}
