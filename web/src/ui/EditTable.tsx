// An editable table of numbers, typed or pasted from a spreadsheet.

import type { ComponentChildren } from 'preact';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { isSame } from '../toml/differences';
import type { TomlValue } from '../toml/format';
import { cellText } from '../settings/numbers';
import { readPasted, withoutNames } from '../settings/pasted';
import { overlaid, rowValue } from '../settings/rows';
import {
  asGiven,
  isBlank,
  placesInProject,
  sentencesOf,
  settled,
  withWaiting,
  type Row,
  type Waiting,
} from '../settings/waitingRows';
import { PasteDialog, type Cell } from './PasteDialog';
import { TypedInput } from './TypedInput';

interface Props {
  label: string;
  columns: string[];
  /// The cells in the project.
  cells: string[][];
  /// The number of cells of a row that must not be empty.
  least: number;
  take: (rows: TomlValue[][], what: string) => void;
  /// Incomplete rows, and the function that stores them.
  waiting: readonly Waiting[];
  keepWaiting: (rows: readonly Waiting[]) => void;
  /// Whether a cell of the project has an error, and the id of the element that describes it.
  isWrong?: (row: number, column: number) => boolean;
  describedBy?: string;
  /// Further buttons below the table.
  children?: ComponentChildren;
}

const page = 100;
const withoutBlanks = (rows: Row[]) => rows.slice(0, rows.findLastIndex(({ cells }) => !isBlank(cells)) + 1);

export function EditTable(props: Props) {
  const { label, columns, cells, least, take, waiting, keepWaiting, isWrong, describedBy, children } = props;
  const [first, setFirst] = useState(0);
  const [pasting, setPasting] = useState<{ begun: (Cell & { text: string }) | null } | null>(null);
  const focus = useRef<[number, number] | null>(null);
  const table = useRef<HTMLTableElement>(null);
  const shown = withWaiting(cells, waiting);
  const blank: Row = { cells: Array<string>(columns.length).fill(''), given: null };
  // The last row is always empty, for typing the next one.
  const rendered = isBlank(shown.at(-1)?.cells ?? ['.']) ? shown : [...shown, blank];

  const change = (next: Row[], what: string) => {
    const now = settled(withoutBlanks(next), least);
    if (!isSame(now.rows, cells.map(asGiven))) take(now.rows, what);
    keepWaiting(now.waiting);
  };
  // The number of required cells can change, too.
  const isComplete = waiting.some((row) => rowValue(row.cells, least) !== undefined);
  useEffect(() => {
    if (isComplete) change(shown, 'complete rows of');
  }, [isComplete]);
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

  const changeCell = (r: number, c: number, text: string) => {
    const { cells: before, given } = rendered[r]!;
    change(rendered.with(r, { cells: before.with(c, text), given }), 'change');
  };
  const places = placesInProject(rendered);
  const isWrongCell = (r: number, c: number) => places[r] !== null && (isWrong?.(places[r]!, c) ?? false);
  const insert = (at: number) => {
    if (at < shown.length) change(shown.toSpliced(at, 0, blank), 'insert a row in');
    go(at, 0);
  };
  const paste = (text: string, row: number, column: number) => {
    const { rows, open } = readPasted(text);
    if (rows.length === 0) return false;
    const block = column === 0 ? withoutNames(rows, columns.length) : rows;
    const isTooWide = block.some((line) => column + line.length > columns.length);
    if (isTooWide || open) setPasting({ begun: { text, row, column } });
    else lay(rendered, block, row, column);
    return true;
  };
  const lay = (over: Row[], block: string[][], row: number, column: number) => {
    const laid = overlaid(
      over.map((one) => one.cells),
      block,
      row,
      column,
      columns.length,
    );
    change(
      laid.map((next, k) => ({ cells: next, given: over[k]?.given ?? null })),
      'paste rows into',
    );
  };
  const onKey = (event: KeyboardEvent, row: number, column: number) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'ArrowUp' && row > 0) go(row - 1, column);
    else if (event.key === 'ArrowDown' && row + 1 < rendered.length) go(row + 1, column);
    else if (event.key === 'Enter') {
      // Leaving the cell stores it, which completes the row before the next one is focused.
      (event.currentTarget as HTMLElement).blur();
      go(row + 1, 0);
    } else return;
    event.preventDefault();
  };

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
                        value={row.cells[c] === '' ? undefined : row.cells[c]}
                        invalid={isWrongCell(r, c)}
                        describedBy={isWrongCell(r, c) ? describedBy : undefined}
                        take={(value) => changeCell(r, c, value === undefined ? '' : cellText(value))}
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
      {sentencesOf(waiting).map((sentence) => (
        <p key={sentence} class="problem warning">
          {sentence}
        </p>
      ))}
      <div class="row">
        <button class="button" onClick={() => insert(shown.length)}>
          Insert row
        </button>
        <button class="button" onClick={() => setPasting({ begun: null })}>
          Paste rows…
        </button>
        {children}
      </div>
      {pasting && (
        <PasteDialog
          columns={columns}
          hasRows={shown.length > 0}
          begun={pasting.begun}
          close={() => setPasting(null)}
          take={(rows, where) => {
            if (where === 'instead') lay([], rows, 0, 0);
            else if (where === 'below') lay(shown, rows, shown.length, 0);
            else lay(rendered, rows, where.row, where.column);
            setPasting(null);
          }}
        />
      )}
    </div>
  );
}
