// A table of results, saved and copied with all digits.

import type { ComponentChildren } from 'preact';
import { decimalsOf, dividedText } from '../units/texts';
import type { NumberText } from '../api/exact';
import { allDigits } from './allDigits';
import { displayOf } from '../state/displayUnits';
import { asInFiles, displayOfColumn } from './columns';
import { saveCsv } from '../figures/files';
import { fixedText, measured } from '../units/numbers';
import { copyRows } from './save';

export interface Column {
  /// The column name in the file.
  key: string;
  title: string;
  unit?: string;
  /// The column of the results that it shows, if it has another name.
  quantity?: string;
  isText?: boolean;
  /// Whether its texts are units.
  isUnit?: boolean;
}

interface Props {
  caption: string;
  file: string;
  columns: readonly Column[];
  /// Texts as in the files; '' is unknown.
  rows: readonly (readonly NumberText[])[];
  /// Whether the first column has row headings.
  hasHeads?: boolean;
  exact?: boolean;
  /// Whether all numbers of a column have the same number of decimals.
  isSeries?: boolean;
  tools?: ComponentChildren;
  /// The unit of a number if it differs from its column's.
  unitAt?: (row: number, column: number) => string | undefined;
  rowClass?: (row: number) => string;
}

const displayIn = ({ key, quantity = key, unit: own = '' }: Column, unit = own) => displayOfColumn(quantity, unit);

/// The text in the displayed unit.
function displayedText(text: NumberText, column: Column, unit: string): string {
  if (column.isUnit) return displayOf(text).unit;
  return column.isText ? text : dividedText(text, displayIn(column, unit).per);
}

/// The text as shown, rounded unless `exact`; `decimals` of its column, if fixed.
function shownText(whole: string, { isText }: Column, exact: boolean, decimals: number | null): string {
  if (whole === '') return '–';
  const value = Number(whole);
  if (exact || isText || Number.isNaN(value)) return whole;
  return decimals === null ? measured(value) : fixedText(value, decimals);
}

export function DataTable(props: Props) {
  const { caption, file, columns, rows, hasHeads, exact = allDigits.value, isSeries, tools, unitAt, rowClass } = props;
  const isConverted = columns.some((column) => column.isUnit || displayIn(column).per !== 1);
  const remark = isConverted ? asInFiles() : undefined;
  const displayed = rows.map((row, k) => row.map((text, c) => displayedText(text, columns[c]!, unitAt?.(k, c) ?? columns[c]!.unit ?? '')));
  const decimals = columns.map(({ isText }, c) =>
    isSeries && !isText ? decimalsOf(displayed.flatMap((row) => (row[c] === '' ? [] : [Number(row[c])]))) : null,
  );
  const all = () => [columns.map(({ key }) => key), ...rows.map((row) => [...row])];
  return (
    <div class="data-table">
      <div class="table-tools">
        <h3>{caption}</h3>
        {tools}
        <button class="button plain" title={remark} onClick={() => copyRows(all())}>
          Copy
        </button>
        <button class="button plain" title={remark} onClick={() => saveCsv(file, all())}>
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
                  {column.unit && <span class="unit">{displayIn(column).unit}</span>}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, k) => (
              <tr key={k} class={rowClass?.(k) ?? ''}>
                {row.map((_, c) => {
                  const column = columns[c]!;
                  const whole = displayed[k]![c]!;
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
