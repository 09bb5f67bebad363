// A table of numbers that is typed in, or pasted from a spreadsheet.

import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { TomlValue } from '../../toml/format';
import { Dialog } from '../../ui/Dialog';
import { pastedRows, withoutNames } from '../numbers';
import { overlaid, rowsValue } from '../rows';
import { TypedInput } from './TypedInput';

interface Props {
  label: string;
  columns: string[];
  /// As the project has them.
  cells: string[][];
  /// How many cells of a row may not be empty.
  least: number;
  take: (rows: TomlValue[][], what: string) => void;
  /// Further buttons below the table.
  children?: ComponentChildren;
}

const page = 100;
const isBlank = (row: readonly string[]) => row.every((cell) => cell.trim() === '');
const withoutBlanks = (rows: string[][]) => rows.slice(0, rows.findLastIndex((row) => !isBlank(row)) + 1);

export function EditTable({ label, columns, cells, least, take, children }: Props) {
  // Rows that are not complete yet, over the rows that the project had when they were begun.
  const [draft, setDraft] = useState<{ cells: string[][]; over: string } | null>(null);
  const [first, setFirst] = useState(0);
  const [pasting, setPasting] = useState(false);
  const focus = useRef<[number, number] | null>(null);
  const table = useRef<HTMLTableElement>(null);
  const over = JSON.stringify(cells);
  const shown = draft && draft.over === over ? draft.cells : cells;
  const blank = Array<string>(columns.length).fill('');
  // The last row is always empty, for the next one to be typed.
  const rendered = isBlank(shown.at(-1) ?? ['.']) ? shown : [...shown, blank];

  const change = (next: string[][], what: string) => {
    const rows = rowsValue(withoutBlanks(next), least);
    setDraft(rows ? null : { cells: next, over });
    if (rows) take(rows, what);
  };
  const go = (row: number, column: number) => {
    focus.current = [row, column];
    if (row < first || row >= first + page) setFirst(Math.floor(row / page) * page);
    find();
  };
  const find = () => {
    const [row, column] = focus.current ?? [];
    const input = table.current?.querySelector<HTMLInputElement>(
      `input[data-cell="${row},${column}"], [data-cell="${row},${column}"] input`,
    );
    if (!input) return;
    focus.current = null;
    input.focus();
    input.select();
  };
  useLayoutEffect(find);

  const insert = (at: number) => {
    if (at < shown.length) change(shown.toSpliced(at, 0, blank), 'insert a row in');
    go(at, 0);
  };
  const paste = (text: string, row: number, column: number) => {
    const block = pastedRows(text);
    if (block.length === 0) return false;
    const next = overlaid(
      rendered,
      column === 0 ? withoutNames(block, columns.length) : block,
      row,
      column,
      columns.length,
    );
    change(next, 'paste rows into');
    return true;
  };
  const onKey = (event: KeyboardEvent, row: number, column: number) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'ArrowUp' && row > 0) go(row - 1, column);
    else if (event.key === 'ArrowDown' && row + 1 < rendered.length) go(row + 1, column);
    else if (event.key === 'Enter') {
      // The cell is taken first: a row that is complete makes way for the next.
      (event.currentTarget as HTMLElement).blur();
      go(row + 1, 0);
    } else return;
    event.preventDefault();
  };

  const waiting = withoutBlanks(shown).findIndex((row) => rowsValue([row], least) === undefined);
  return (
    <div class="edit-table">
      <div class="scroll">
        <table ref={table} aria-label={label}>
          <thead>
            <tr>
              <th scope="col">
                <span class="visually-hidden">Row</span>
              </th>
              {columns.map((column) => (
                <th key={column} scope="col">
                  {column}
                </th>
              ))}
              <th scope="col">
                <span class="visually-hidden">Change rows</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {rendered.slice(first, first + page).map((row, k) => {
              const r = first + k;
              return (
                <tr key={r}>
                  <th scope="row" class="faint">
                    {r + 1}
                  </th>
                  {columns.map((column, c) => (
                    <td key={column} data-cell={`${r},${c}`}>
                      <TypedInput
                        label={`${column}, row ${r + 1}`}
                        value={row[c] === '' ? undefined : row[c]}
                        take={(value) =>
                          change(rendered.with(r, row.with(c, value === undefined ? '' : String(value))), 'change')
                        }
                        onKeyDown={(event) => onKey(event, r, c)}
                        onPaste={(event) => {
                          const text = event.clipboardData?.getData('text') ?? '';
                          if (/[\t\r\n;]/.test(text.trim()) && paste(text, r, c)) event.preventDefault();
                        }}
                      />
                    </td>
                  ))}
                  <td class="acts">
                    {r < shown.length && (
                      <>
                        <button
                          class="mini"
                          title="Insert a row above"
                          aria-label={`Insert a row above row ${r + 1}`}
                          onClick={() => insert(r)}
                        >
                          +
                        </button>
                        <button
                          class="mini"
                          title="Delete this row"
                          aria-label={`Delete row ${r + 1}`}
                          onClick={() => change(shown.toSpliced(r, 1), 'delete a row of')}
                        >
                          ✕
                        </button>
                      </>
                    )}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
      {shown.length > page && (
        <p class="pages">
          <button class="button" disabled={first === 0} onClick={() => setFirst(first - page)}>
            ‹
          </button>
          Rows {first + 1} to {Math.min(first + page, shown.length)} of {shown.length.toLocaleString('en')}
          <button class="button" disabled={first + page >= shown.length} onClick={() => setFirst(first + page)}>
            ›
          </button>
        </p>
      )}
      {draft && waiting >= 0 && shown === draft.cells && (
        <p class="faint">Row {waiting + 1} is taken when it is complete.</p>
      )}
      <div class="row">
        <button class="button" onClick={() => insert(shown.length)}>
          Insert row
        </button>
        <button class="button" onClick={() => setPasting(true)}>
          Paste rows…
        </button>
        {children}
      </div>
      {pasting && (
        <PasteDialog
          columns={columns}
          hasRows={shown.length > 0}
          close={() => setPasting(false)}
          take={(text, replace) => {
            const block = withoutNames(pastedRows(text), columns.length);
            change(
              overlaid(replace ? [] : shown, block, replace ? 0 : shown.length, 0, columns.length),
              'paste rows into',
            );
            setPasting(false);
          }}
        />
      )}
    </div>
  );
}

interface PasteProps {
  columns: string[];
  hasRows: boolean;
  close: () => void;
  take: (text: string, replace: boolean) => void;
}

function PasteDialog({ columns, hasRows, close, take }: PasteProps) {
  const [text, setText] = useState('');
  const rows = withoutNames(pastedRows(text), columns.length);
  const wrong = rows.findIndex((row) => row.length > columns.length);
  return (
    <Dialog title="Paste rows" close={close}>
      <p class="faint">
        Columns {columns.join(', ')}: copied from a spreadsheet, or apart by commas, semicolons or blanks. A heading is
        left out.
      </p>
      <textarea
        class="mono"
        aria-label="Rows"
        rows={10}
        cols={48}
        value={text}
        onInput={(event) => setText(event.currentTarget.value)}
      />
      <p role="status">
        {rows.length} {rows.length === 1 ? 'row' : 'rows'}
        {wrong >= 0 && (
          <span class="problem">
            Row {wrong + 1} has {rows[wrong]!.length} columns; {columns.length} are taken, from the left.
          </span>
        )}
      </p>
      <div class="row">
        <button class="button first" disabled={rows.length === 0} onClick={() => take(text, true)}>
          {hasRows ? 'Replace all rows' : 'Take the rows'}
        </button>
        {hasRows && (
          <button class="button" disabled={rows.length === 0} onClick={() => take(text, false)}>
            Add below
          </button>
        )}
      </div>
    </Dialog>
  );
}
