// Controls of settings that are points: one, rows of them, lists of rows.

import { useEffect } from 'preact/hooks';
import { edit, valueAt, values } from '../../state/document';
import { problemsAt } from '../../state/model';
import type { Path } from '../names';
import type { TomlValue } from '../../toml/format';
import { columnsAt } from '../columns';
import { consequences } from '../consequences';
import { cellText } from '../numbers';
import { is2d, pathText, put, tableAt, thingOf } from '../place';
import { absentText } from '../words';
import { cellsOf, rowEdits, rowValue } from '../rows';
import { wait, waitingAt } from '../unfinished';
import { isBlank, isSameRow, type Waiting } from '../waitingRows';
import { Choice } from './Choice';
import { DrawButton } from './DrawButton';
import { EditTable } from './EditTable';
import { idOf, sayingsId, type FieldProps } from './fieldProps';
import { TypedInput } from './TypedInput';

/// How many numbers a position has at the least: its height may be left out where `height_above_m` says it.
function leastOf({ field, path }: FieldProps, columns: number): number {
  const words = 'words' in field.type ? field.type.words : [];
  const mayBeLeftOut = words.includes('surface') && tableAt(path.slice(0, 2)).height_above_m !== undefined;
  return mayBeLeftOut ? columns - 1 : columns;
}

/// The cells of a setting that the engine says something against.
function wrongCells(path: Path): (row: number, column: number) => boolean {
  const own = pathText(path);
  const wrong = new Set(problemsAt(own).flatMap(({ severity, path: at }) => (severity === 'error' ? [at] : [])));
  return (row, column) => wrong.has(`${own}.${row}`) || wrong.has(`${own}.${row}.${column}`);
}

/// What a table of a setting's rows needs to know, besides the rows; `field` is where problems are told.
export function tableProps(path: Path, field: Path = path) {
  const own = pathText(path);
  return {
    waiting: waitingAt(own),
    wait: (rows: readonly Waiting[]) => wait(own, rows),
    isWrong: wrongCells(path),
    describedBy: sayingsId(field),
  };
}

/// Where one word may stand for all numbers: which, or the numbers.
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
        describedBy={sayingsId(path)}
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
  const draft = waitingAt(pathText(path)).find(({ over }) => isSameRow(over, given));
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
    wait(own, row || isBlank(changed) ? [] : [{ at: 0, cells: changed, over: given }]);
  };
  const missing = columns.filter((_, k) => k < least && cells[k] === '');
  // How much it needs can change, too: a height above the ground makes up for z.
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
              describedBy={[isWrong(k) && sayingsId(path), draft && `${id}-draft`].filter(Boolean).join(' ') || undefined}
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
          Taken when {missing.join(' and ')} is given, too
          {missing.join() === 'z' && words.includes('surface') && ', or a height above'}
          {given && '; the project keeps it as before'}.
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

/// What becomes of the materials of segments when vertices come and go.
function WhatFollows() {
  const segments = valueAt(['ground', 'segments']);
  if (!Array.isArray(segments) || segments.length === 0) return null;
  return (
    <p class="faint">
      Segments keep their materials: both parts of one that a new vertex splits; where a vertex goes, the segment before
      it. Of rows that are replaced by more or fewer, each segment has the material that lay nearest.
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
            describedBy={sayingsId(path)}
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
