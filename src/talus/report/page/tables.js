// Tables. A cell is a text, or {text, full, below, draw}: `full` is its tooltip, `below` a second line in small type.

function table(parent, {caption, head, rows, numeric = () => false, rowClass}) {
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

// One table for both runs if they agree, otherwise one for each.
function forEachRun(caption, listOfRun, show) {
  const lists = runs.map(listOfRun);
  const same = !single && JSON.stringify(lists[0]) === JSON.stringify(lists[1]);
  runs.forEach((run, i) => {
    if ((same && i > 0) || !lists[i].length) return;
    show(single || same ? caption : `${caption} · ${run.label}`, lists[i]);
  });
}

// Items with settings, {name, key: value, ...}: one row each if the settings are few, otherwise one column each, with as
// many columns per table as fit on paper.
function listTable(parent, caption, listOfRun, textOf) {
  const mostKeysInARow = 5, mostColumns = 5;
  const isGiven = (value) => value !== null && value !== undefined;
  forEachRun(caption, listOfRun, (title, list) => {
    const keys = [...new Set(list.flatMap(Object.keys))].filter((key) => key !== 'name' && list.some((item) => isGiven(item[key])));
    const cell = (item, key) => isGiven(item[key]) ? textOf(key, item[key]) : '–';
    if (keys.length <= mostKeysInARow) {
      table(parent, {
        caption: title,
        head: [['name', ...keys].map((key) => ({text: wordsOf(key), unit: unitOf(key)}))],
        rows: list.map((item) => [item.name, ...keys.map((key) => cell(item, key))]),
      });
      return;
    }
    const columns = Math.ceil(list.length / Math.ceil(list.length / mostColumns));
    for (let from = 0; from < list.length; from += columns) {
      const shown = list.slice(from, from + columns);
      table(parent, {
        caption: from === 0 ? title : `${title}, continued`,
        head: [['', ...shown.map((item) => item.name)]],
        rows: keys.filter((key) => shown.some((item) => isGiven(item[key])))
          .map((key) => [{text: wordsOf(key), unit: unitOf(key)}, ...shown.map((item) => cell(item, key))]),
      });
    }
  });
}

// A table of [label, value] rows, `rowsOf(run)`; one for each run where they differ.
function factsTable(parent, caption, rowsOf) {
  forEachRun(caption, rowsOf, (title, rows) => table(parent, {caption: title, head: [], rows}));
}
