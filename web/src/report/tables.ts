// Tables.

import type { Group } from '../figures/plot';
import { element } from './figure';

/// A cell of the head: a text, its unit, and the number of columns below it; `run`: it names a run, in its colour.
export interface HeadCell {
  text: string;
  unit?: string;
  span?: number;
  run?: { colour: string };
}
/// A cell: `full` is its tooltip, `below` a second line in small type; `draw` adds more.
export interface BodyCell {
  text: string;
  unit?: string;
  full?: string | null;
  below?: string | null | undefined;
  draw?: (cell: Group) => void;
}
export type Row = readonly (string | BodyCell)[];

export interface TableOptions {
  caption?: string | null | undefined;
  head: readonly (readonly (string | HeadCell)[])[];
  rows: readonly Row[];
  /// Whether a column has numbers, which are aligned on the right.
  numeric?: (column: number) => boolean;
  rowClass?: (row: number) => string;
}

const mostRowsKeptTogether = 30; // a longer table may break across pages, with its head repeated

const whole = <Cell extends { text: string }>(cell: string | Cell): Cell | { text: string } =>
  typeof cell === 'string' ? { text: cell } : cell;

export function table(parent: Group, { caption, head, rows, numeric = () => false, rowClass }: TableOptions): Group {
  const node = element(element(parent, 'div', null, { class: 'scroll' }), 'table');
  if (rows.length > mostRowsKeptTogether) node.attr('class', 'long');
  if (caption) element(node, 'caption', caption);
  const thead: Group = node.append('thead');
  for (const [level, cells] of head.entries()) {
    const row = element(thead, 'tr', null, { class: level + 1 < head.length ? 'group' : '' });
    let column = 0;
    for (const cell of cells) {
      const { text, unit, span = 1, run }: HeadCell = whole(cell);
      const th = element(row, 'th', null, { colspan: span, scope: 'col', class: numeric(column) && span === 1 ? 'n' : '' });
      if (run) element(th, 'span', text, { class: 'run-name' }).style('--run', run.colour);
      else element(th, 'span', text);
      if (unit) element(th, 'span', ` [${unit}]`, { class: 'unit' });
      column += span;
    }
  }
  const tbody: Group = node.append('tbody');
  rows.forEach((cells, index) => {
    const row = element(tbody, 'tr', null, { class: rowClass?.(index) ?? '' });
    cells.forEach((cell, column) => {
      const { text, unit, full, below, draw }: BodyCell = whole(cell);
      const isName = column === 0;
      const td = element(row, isName ? 'th' : 'td', text, {
        ...(isName && { scope: 'row' }),
        class: !isName && numeric(column) ? 'n' : 'name',
      });
      if (unit) element(td, 'span', ` [${unit}]`, { class: 'unit' });
      if (below) element(td, 'span', below, { class: 'below' });
      if (full !== undefined && full !== null) td.attr('title', full);
      draw?.(td);
    });
  });
  return node;
}
