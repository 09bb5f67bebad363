// Tables. A cell is a text, or {text, full, below, draw}: `full` is its tooltip, `below` a second line in small type.

import { element } from './figure';

export function table(parent, {caption, head, rows, numeric = () => false, rowClass}) {
  const node = element(element(parent, 'div', null, {class: 'scroll'}), 'table');
  if (rows.length > mostRowsKeptTogether) node.attr('class', 'long');
  if (caption) element(node, 'caption', caption);
  const thead = node.append('thead');
  for (const [level, cells] of head.entries()) {
    const row = element(thead, 'tr', null, {class: level + 1 < head.length ? 'group' : ''});
    let column = 0;
    for (const cell of cells) {
      const {text, unit, span = 1, run} = typeof cell === 'object' ? cell : {text: cell};
      const th = element(row, 'th', null, {colspan: span, scope: 'col', class: numeric(column) && span === 1 ? 'n' : ''});
      if (run) element(th, 'span', text, {class: 'run-name'}).style('--run', run.colour);
      else th.append('span').text(text);
      if (unit) element(th, 'span', ` [${unit}]`, {class: 'unit'});
      column += span;
    }
  }
  const tbody = node.append('tbody');
  rows.forEach((cells, index) => {
    const row = element(tbody, 'tr', null, {class: rowClass ? rowClass(index) : ''});
    cells.forEach((cell, column) => {
      const {text, unit, full, below, draw} = cell !== null && typeof cell === 'object' ? cell : {text: cell};
      const td = column === 0 ? element(row, 'th', text, {scope: 'row', class: 'name'}) : element(row, 'td', text, {class: numeric(column) ? 'n' : 'name'});
      if (unit) element(td, 'span', ` [${unit}]`, {class: 'unit'});
      if (below) element(td, 'span', below, {class: 'below'});
      if (full !== undefined && full !== null) td.attr('title', full);
      if (draw) draw(td);
    });
  });
  return node;
}

const mostRowsKeptTogether = 30;  // a longer table may break across pages, with its head repeated
