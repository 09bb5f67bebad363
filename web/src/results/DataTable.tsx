// A table of results, which can be saved and copied with all its digits.

import type { ComponentChildren } from 'preact';
import { decimalsOf, shiftedText } from '../ui/format';
import type { NumberText } from '../api/exact';
import { allDigits } from '../state/view';
import { asInFiles, readingOf } from './columns';
import { saveCsv } from '../figures/files';
import { fixedText, measured } from '../figures/format';
import { copyRows } from './save';

export interface Column {
  /// As in the file.
  key: string;
  title: string;
  unit?: string;
  isText?: boolean;
  /// Its texts are units.
  isUnit?: boolean;
}

interface Props {
  caption: string;
  file: string;
  columns: readonly Column[];
  /// Texts as the files have them; '' is not known.
  rows: readonly (readonly NumberText[])[];
  /// Whether the first column heads the rows.
  hasHeads?: boolean;
  exact?: boolean;
  /// Whether the numbers of a column are of one kind, and have as many decimals.
  isSeries?: boolean;
  tools?: ComponentChildren;
  /// The unit of a number where it is not its column's.
  unitAt?: (row: number, column: number) => string | undefined;
  rowClass?: (row: number) => string;
}

/// In the unit in which it is read.
function readText(text: NumberText, { isText, isUnit }: Column, unit: string): string {
  if (isUnit) return readingOf(text).unit;
  return isText ? text : shiftedText(text, readingOf(unit).places);
}

/// `decimals`: of its column, where there are such.
function shownText(read: string, { isText }: Column, exact: boolean, decimals: number | null): string {
  if (read === '') return '–';
  const value = Number(read);
  if (exact || isText || Number.isNaN(value)) return read;
  return decimals === null ? measured(value) : fixedText(value, decimals);
}

export function DataTable(props: Props) {
  const { caption, file, columns, rows, hasHeads, exact = allDigits.value, isSeries, tools, unitAt, rowClass } = props;
  const isReadOtherwise = columns.some(({ unit = '', isUnit }) => isUnit || readingOf(unit).places !== 0);
  const saying = isReadOtherwise ? asInFiles : undefined;
  const read = rows.map((row, k) => row.map((text, c) => readText(text, columns[c]!, unitAt?.(k, c) ?? columns[c]!.unit ?? '')));
  const decimals = columns.map(({ isText }, c) =>
    isSeries && !isText ? decimalsOf(read.flatMap((row) => (row[c] === '' ? [] : [Number(row[c])]))) : null,
  );
  const all = () => [columns.map(({ key }) => key), ...rows.map((row) => [...row])];
  return (
    <div class="data-table">
      <div class="table-tools">
        <h3>{caption}</h3>
        {tools}
        <button class="button plain" title={saying} onClick={() => copyRows(all())}>
          Copy
        </button>
        <button class="button plain" title={saying} onClick={() => saveCsv(file, all())}>
          CSV
        </button>
      </div>
      <div class="table-scroll" tabIndex={0} role="region" aria-label={caption}>
        <table>
          <thead>
            <tr>
              {columns.map((column) => (
                <th key={column.key} scope="col" class={column.isText ? '' : 'number'}>
                  {column.title}
                  {column.unit && <span class="unit">{readingOf(column.unit).unit}</span>}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, k) => (
              <tr key={k} class={rowClass?.(k) ?? ''}>
                {row.map((_, c) => {
                  const column = columns[c]!;
                  const whole = read[k]![c]!;
                  const shown = shownText(whole, column, exact, decimals[c]!);
                  return c === 0 && hasHeads ? (
                    <th key={column.key} scope="row">
                      {shown}
                    </th>
                  ) : (
                    <td
                      key={column.key}
                      class={column.isText ? '' : 'number'}
                      title={shown === whole ? undefined : whole}
                    >
                      {shown}
                    </td>
                  );
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </div>
  );
}
