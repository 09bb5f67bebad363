// A table of results, which can be saved and copied with all its digits.

import type { ComponentChildren } from 'preact';
import { numberText } from '../ui/format';
import type { NumberText } from '../api/exact';
import { allDigits } from '../state/view';
import { copyRows, saveCsv } from './save';

export interface Column {
  /// As in the file.
  key: string;
  title: string;
  unit?: string;
  isText?: boolean;
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
  tools?: ComponentChildren;
  rowClass?: (row: number) => string;
}

function shownText(text: NumberText, { isText }: Column, exact: boolean): string {
  if (text === '') return '–';
  const value = Number(text);
  if (exact || isText || Number.isNaN(value)) return text;
  return numberText(value, 4);
}

export function DataTable({ caption, file, columns, rows, hasHeads, exact = allDigits.value, tools, rowClass }: Props) {
  const all = () => [columns.map(({ key }) => key), ...rows.map((row) => [...row])];
  return (
    <div class="data-table">
      <div class="table-tools">
        <h3>{caption}</h3>
        {tools}
        <button class="button plain" onClick={() => copyRows(all())}>
          Copy
        </button>
        <button class="button plain" onClick={() => saveCsv(file, all())}>
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
                  {column.unit && <span class="unit">{column.unit}</span>}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, k) => (
              <tr key={k} class={rowClass?.(k) ?? ''}>
                {row.map((text, c) => {
                  const column = columns[c]!;
                  const shown = shownText(text, column, exact);
                  return c === 0 && hasHeads ? (
                    <th key={column.key} scope="row">
                      {shown}
                    </th>
                  ) : (
                    <td key={column.key} class={column.isText ? '' : 'number'} title={shown === text ? undefined : text}>
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
