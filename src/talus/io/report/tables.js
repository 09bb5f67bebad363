// The words and numbers of the page: cards, settings, materials, seeders, barriers, statistics, reasons to end.

function table(parent, {caption, head, rows, numeric = () => false, rowClass}) {
  const node = element(element(parent, 'div', null, {class: 'scroll'}), 'table');
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
      const {text, full, draw} = cell !== null && typeof cell === 'object' ? cell : {text: cell};
      const td = column === 0 ? element(row, 'th', text, {scope: 'row', class: 'name'}) : element(row, 'td', text, {class: numeric(column) ? 'n' : 'name'});
      if (full !== undefined && full !== null) td.attr('title', full);
      if (draw) draw(td);
    });
  });
  return node;
}

// ---- the thirteen rows of a spreadsheet's descriptive statistics; `power` is that of the unit in each row

const statisticsRows = [
  ['mean', 'Mean', 1], ['standard_error', 'Standard error', 1], ['median', 'Median', 1],
  ['standard_deviation', 'Standard deviation', 1], ['sample_variance', 'Sample variance', 2], ['kurtosis', 'Kurtosis', 0],
  ['skewness', 'Skewness', 0], ['range', 'Range', 1], ['minimum', 'Minimum', 1], ['maximum', 'Maximum', 1],
  ['sum', 'Sum', 1], ['count', 'Count', 0], ['confidence_level_95', 'Confidence level (95.0 %)', 1],
];

// `quantities`: [{text, unit, per, of: (run) => statistics}], where `per` turns the file's unit into the one shown.
function statisticsTable(parent, shown, quantities, caption) {
  const kept = quantities.filter((q) => shown.some((run) => q.of(run)));
  if (!kept.length) return element(parent, 'p', 'The summary holds no statistics of this.', {class: 'quiet'});
  const most = 3;  // of two runs side by side: more would not fit on paper
  if (shown.length > 1 && kept.length > most) {
    for (let i = 0; i < kept.length; i += most) statisticsTable(parent, shown, kept.slice(i, i + most), i === 0 ? caption : null);
    return null;
  }
  const head = [[''].concat(kept.map((q) => ({text: q.text, unit: q.unit, span: shown.length})))];
  if (shown.length > 1) head.push([''].concat(kept.flatMap(() => shown.map((run) => ({text: run.label, run})))));
  const rows = statisticsRows.map(([key, words, power]) => [words].concat(kept.flatMap((q) => shown.map((run) => {
    const value = (q.of(run) || {})[key];
    if (!isNumber(value)) return '–';
    const scaled = value / (q.per || 1) ** power;
    return {text: number(scaled, 7), full: String(scaled)};
  }))));
  return table(parent, {caption, head, rows, numeric: (column) => column > 0});
}

// ---- cards

function cards(parent) {
  const box = element(parent, 'div', null, {class: 'cards'});
  const card = (what, valueOf) => {
    const values = runs.map(valueOf);
    if (values.every((v) => v === null)) return;
    const node = element(box, 'div', null, {class: 'card'});
    element(node, 'div', what, {class: 'what'});
    values.forEach((value, i) => {
      const line = element(node, 'div', null, {class: 'value'});
      if (!single) line.style('color', runs[i].colour);
      line.append('span').text(value === null ? '–' : value[0]);
      if (value && value[1]) element(line, 'small', ' ' + value[1]);
    });
  };
  const statistic = (name, key, unit, per = 1, digits = 4) => (run) => {
    const value = (run.statistics[name] || {})[key];
    return isNumber(value) ? [number(value / per, digits), unit] : null;
  };
  card('Rocks thrown', (run) => run.summary.rocks ? [number(run.summary.rocks.done), run.summary.interrupted ? `of ${number(run.summary.rocks.planned)}` : ''] : null);
  card('Mean runout (plan)', statistic('runout_xy_m', 'mean', 'm'));
  card('Longest runout (plan)', statistic('runout_xy_m', 'maximum', 'm'));
  card('Greatest kinetic energy', statistic('max_ke_J', 'maximum', 'kJ', 1000));
  card('Greatest bounce height', statistic('max_bounce_m', 'maximum', 'm'));
  const names = [...new Set(runs.flatMap((run) => run.barriers.map((b) => b.name)))];
  if (names.length > 0 && names.length <= 2) {
    for (const name of names) {
      card(`Reached ${name}`, (run) => {
        const b = run.barriers.find((other) => other.name === name);
        return b ? [number(b.hits), `hits, ${number(b.passed_above)} above`] : null;
      });
    }
  }
}

// ---- what was run

function warnings(parent) {
  const lines = runs.flatMap((run) => {
    const mark = single ? '' : run.label + ': ';
    const rocks = run.summary.rocks || {};
    const stopped = run.summary.interrupted ? [`${mark}The run was interrupted: ${number(rocks.done)} of ${number(rocks.planned)} rocks are done.`] : [];
    return [...stopped, ...run.warnings.map((w) => mark + (typeof w === 'string' ? w : settingText(w))), ...[...(run.summary.notes || []), ...run.notes].map((n) => mark + n)];
  });
  if (!lines.length) return element(parent, 'p', 'The run gave no warnings.', {class: 'quiet'});
  const list = element(element(parent, 'div', null, {class: 'note'}), 'ul');
  for (const line of lines) element(list, 'li', line);
}

function settings(parent) {
  const groups = ['analysis', 'sampling', 'design', 'output'];
  const hidden = new Set(['report', 'paths', 'path_limit', 'maps']);
  const keys = [...new Set(runs.flatMap((run) => groups.flatMap((group) => Object.keys(run.project[group] || {}).filter((k) => !hidden.has(k)).map((k) => group + '/' + k))))];
  if (!keys.length) return element(parent, 'p', 'The summary does not hold the project.', {class: 'quiet'});
  const valueOf = (run, key) => {
    const [group, name] = key.split('/');
    return run.project[group] ? settingText(run.project[group][name]) : '–';
  };
  const differs = (i) => !single && valueOf(runs[0], keys[i]) !== valueOf(runs[1], keys[i]);
  const half = single && keys.length > 8 ? Math.ceil(keys.length / 2) : keys.length;
  const box = element(parent, 'div', null, {class: half < keys.length ? 'columns' : ''});
  for (let from = 0; from < keys.length; from += half) {
    const part = keys.slice(from, from + half);
    table(box, {
      head: [[{text: 'Setting'}, ...(single ? [{text: 'Value'}] : runs.map((run) => ({text: run.label, run}))), {text: 'Unit'}]],
      rows: part.map((key) => [(key.startsWith('design/') ? 'Design: ' : '') + wordsOf(key.split('/')[1]), ...runs.map((run) => valueOf(run, key)), unitOf(key) || '']),
      rowClass: (i) => differs(from + i) ? 'differs' : '',
    });
  }
  if (!single && keys.some((key, i) => differs(i))) element(parent, 'p', 'Settings that differ are shaded.', {class: 'quiet'});
}

// One table for both runs where they agree, else one for each.
function listTable(parent, caption, rowsOf, textOf) {
  const lists = runs.map(rowsOf);
  const same = !single && JSON.stringify(lists[0]) === JSON.stringify(lists[1]);
  runs.forEach((run, i) => {
    if (same && i > 0) return;
    const list = lists[i];
    const title = single || same ? caption : `${caption} · ${run.label}`;
    if (!list.length) return;
    const keys = [...new Set(list.flatMap(Object.keys))].filter((key) => list.some((item) => item[key] !== null && item[key] !== undefined));
    table(parent, {
      caption: title,
      head: [keys.map((key) => ({text: wordsOf(key), unit: unitOf(key)}))],
      rows: list.map((item) => keys.map((key) => textOf(key, item[key]))),
    });
  });
}

function inputs(parent) {
  const lumped = runs.every((run) => (run.project.analysis || {}).model === 'lumped_mass');
  const rigidOnly = new Set(['dynamic_friction', 'rolling_friction', 'roughness_spacing_m', 'roughness_amplitude_m']);
  const withName = ({name, ...rest}) => ({name, ...rest});
  listTable(parent, 'Materials', (run) => materialsOf(run).map((m) => {
    const shown = Object.entries(withName(m)).filter(([key]) => !(lumped && rigidOnly.has(key)));
    return Object.fromEntries(shown);
  }), (key, value) => property(value));
  const groundOf = (run) => {
    const ground = run.project.ground || {};
    const rows = [];
    const fallback = ground.default ?? ground.default_material;
    if (fallback) rows.push({part: 'Default', material: fallback});
    if (Array.isArray(ground.segments)) ground.segments.forEach((name, i) => rows.push({part: `Segment ${i + 1}`, material: name}));
    return rows;
  };
  listTable(parent, 'Ground', groundOf, (key, value) => value);
  const unwanted = new Set(['line', 'source_line', 'is_collector']);
  listTable(parent, 'Seeders', (run) => seedersOf(run).map((s) => {
    const shown = Object.entries(withName(s)).filter(([key, value]) => !(key === 'line' && typeof value === 'number') && value !== false);
    return Object.fromEntries(shown);
  }), (key, value) => settingText(value));
  listTable(parent, 'Barriers and collectors', (run) => barriersOf(run).map(({name, collector, ...rest}) => {
    const kept = Object.entries(rest).filter(([key]) => !unwanted.has(key) || (key === 'line' && typeof rest.line !== 'string'));
    const row = {name, kind: collector ? 'collector' : 'barrier', ...Object.fromEntries(kept)};
    if (!collector && !isNumber(row.capacity_kJ)) row.capacity_kJ = 'unlimited';
    if (collector) delete row.capacity_kJ;
    return row;
  }), (key, value) => settingText(value));
}

// ---- why the rocks ended

function endReasons(parent) {
  const reasons = [...new Set(runs.flatMap((run) => Object.keys(run.summary.end_reasons || {})))];
  const countOf = (run, reason) => (run.summary.end_reasons || {})[reason] ?? 0;
  const used = reasons.filter((reason) => runs.some((run) => countOf(run, reason) > 0));
  if (!used.length) return element(parent, 'p', 'The summary does not say why rocks ended.', {class: 'quiet'});
  const share = (run, reason) => countOf(run, reason) / (d3.sum(reasons, (r) => countOf(run, r)) || 1);
  const rows = used.map((reason) => [reason, ...runs.flatMap((run) => [
    number(countOf(run, reason)),
    number(100 * share(run, reason), 3) + ' %',
    {text: '', draw: (td) => element(td, 'span', null, {class: 'meter', style: `width:${(160 * share(run, reason)).toFixed(1)}px`}).style('--run', run.colour)},
  ])]);
  const head = [['Reason', ...runs.flatMap(() => ['Rocks', 'Share', ''])]];
  if (!single) head.unshift(['', ...runs.map((run) => ({text: run.label, run, span: 3}))]);
  table(parent, {head, rows, numeric: (column) => column > 0 && column % 3 !== 0});
}
