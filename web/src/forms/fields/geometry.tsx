// Controls of settings with coordinates: one point, rows of points, a line.

import { useEffect } from 'preact/hooks';
import { edit, valueAt, values } from '../../project/document';
import { problemsAt } from '../../project/model';
import type { Path } from '../../settings/names';
import type { TomlValue } from '../../toml/format';
import { columnsAt } from '../../project/columns';
import { consequences } from '../../settings/consequences';
import { cellText } from '../../settings/numbers';
import { is2d, pathText, put, tableAt, thingOf } from '../../project/place';
import { absentText } from '../../settings/words';
import { cellsOf, rowEdits, rowValue } from '../../settings/rows';
import { keepWaiting, waitingAt } from '../../project/unfinished';
import { isBlank, isSameRow, type Waiting } from '../../settings/waitingRows';
import { Choice } from './Choice';
import { DrawButton } from './DrawButton';
import { EditTable } from '../../ui/EditTable';
import { idOf, problemsId, type FieldProps } from './fieldProps';
import { TypedInput } from '../../ui/TypedInput';

/// The minimum number of coordinates of a position. The height may be omitted if `height_above_m` is given.
function leastOf({ field, path }: FieldProps, columns: number): number {
  const words = 'words' in field.type ? field.type.words : [];
  const mayBeLeftOut = words.includes('surface') && tableAt(path.slice(0, 2)).height_above_m !== undefined;
  return mayBeLeftOut ? columns - 1 : columns;
}

/// The cells of a setting that have an error.
function wrongCells(path: Path): (row: number, column: number) => boolean {
  const own = pathText(path);
  const wrong = new Set(problemsAt(own).flatMap(({ severity, path: at }) => (severity === 'error' ? [at] : [])));
  return (row, column) => wrong.has(`${own}.${row}`) || wrong.has(`${own}.${row}.${column}`);
}

/// Properties of the edit table of a setting's rows; `field` is the path of the field that shows the problems.
export function tableProps(path: Path, field: Path = path) {
  const own = pathText(path);
  return {
    waiting: waitingAt(own),
    keepWaiting: (rows: readonly Waiting[]) => keepWaiting(own, rows),
    isWrong: wrongCells(path),
    describedBy: problemsId(field),
  };
}

/// A tuple of numbers, or one word instead of them.
export function TupleControl(props: FieldProps) {
  const { field, path } = props;
  const instead = field.type.kind === 'tuple' ? field.type.instead : [];
  if (instead.length === 0) return <TupleCells {...props} />;
  const value = valueAt(path);
  const isWord = typeof value === 'string';
  return (
    <>
      <Choice
        id={isWord ? idOf(path) : undefined}
        label={`${field.title}, how it is given`}
        words={instead}
        value={isWord ? value : undefined}
        absent="as numbers"
        invalid={isWord && problemsAt(pathText(path)).some(({ severity }) => severity === 'error')}
        describedBy={problemsId(path)}
        take={(word) => put(path, word, field.title)}
      />
      {!isWord && <TupleCells {...props} />}
    </>
  );
}

function TupleCells({ field, path }: FieldProps) {
  const columns = columnsAt(path);
  const value = valueAt(path);
  const given = cellsOf(value === undefined ? [] : [value], columns.length)[0] ?? null;
  const blank = Array<string>(columns.length).fill('');
  const draft = waitingAt(pathText(path)).find(({ replaces }) => isSameRow(replaces, given));
  const cells = draft?.cells ?? given ?? blank;
  const defaults = Array.isArray(field.default) ? field.default : [];
  const words = 'words' in field.type ? field.type.words : [];
  const own = pathText(path);
  const id = idOf(path);
  const wrong = problemsAt(own).flatMap(({ severity, path: at }) => (severity === 'error' ? [at] : []));
  const isWrong = (column: number) => wrong.some((at) => at === own || at === `${own}.${column}`);
  const least = leastOf({ field, path }, columns.length);
  const take = (changed: readonly string[]) => {
    const row = isBlank(changed) ? undefined : rowValue(changed, least);
    if (row || isBlank(changed)) put(path, row, field.title);
    keepWaiting(own, row || isBlank(changed) ? [] : [{ at: 0, cells: changed, replaces: given }]);
  };
  const missing = columns.filter((_, k) => k < least && cells[k] === '');
  // The number of required cells can change, too: a height above the ground replaces z.
  const isComplete = draft !== undefined && rowValue(draft.cells, least) !== undefined;
  useEffect(() => {
    if (isComplete) take(draft.cells);
  }, [isComplete]);
  return (
    <>
      <div class="tuple">
        {columns.map((column, k) => (
          <label key={column}>
            <span class="faint">{column}</span>
            <TypedInput
              id={k === 0 ? id : undefined}
              label={`${field.title}, ${column}`}
              invalid={value !== undefined && isWrong(k)}
              describedBy={[isWrong(k) && problemsId(path), draft && `${id}-draft`].filter(Boolean).join(' ') || undefined}
              value={cells[k] === '' ? undefined : cells[k]}
              placeholder={defaults.length > 0 ? String(defaults[columns.length === 2 && k === 1 ? 2 : k] ?? '') : ''}
              words={column === 'z' && words.length > 0 ? `${id}-words` : undefined}
              take={(next) => take(cells.with(k, cellText(next)))}
            />
          </label>
        ))}
      </div>
      <div class="row">
        <DrawButton path={path} />
      </div>
      {words.length > 0 && (
        <datalist id={`${id}-words`}>
          {words.map((word) => (
            <option key={word} value={word} />
          ))}
        </datalist>
      )}
      {draft && (
        <p id={`${id}-draft`} class="problem warning">
          Incomplete: enter {missing.join(' and ')}
          {missing.join() === 'z' && words.includes('surface') && ' or a height above'}
          {given && '. Until then the project keeps the previous value'}.
        </p>
      )}
    </>
  );
}

export function RowsControl({ field, path }: FieldProps) {
  const columns = columnsAt(path);
  const value = valueAt(path);
  const take = (rows: TomlValue[][], what: string) => {
    if (rows.length === 0 && field.key !== 'section') return put(path, undefined, field.title);
    edit(
      `${what} ${field.title.toLowerCase()} of ${thingOf(path)}`,
      [...rowEdits(path, value, rows), ...consequences(values.value, path, rows)],
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
        {...tableProps(path)}
      >
        <DrawButton path={path} />
      </EditTable>
      {field.key === 'section' && <WhatFollows />}
    </>
  );
}

/// Explains which materials segments have after vertices are added or deleted.
function WhatFollows() {
  const segments = valueAt(['ground', 'segments']);
  if (!Array.isArray(segments) || segments.length === 0) return null;
  return (
    <p class="faint">
      Segments keep their materials. A new vertex splits a segment into two of the same material; deleting a vertex keeps
      the material of the segment before it. If rows are replaced by more or fewer, each segment takes the material of
      the nearest former segment.
    </p>
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
            invalid={value !== undefined && problemsAt(pathText(path)).some(({ severity }) => severity === 'error')}
            describedBy={problemsId(path)}
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
      {...tableProps(path)}
    >
      <DrawButton path={path} />
    </EditTable>
  );
}
