// The first block of the report: cards with the main results, warnings, end reasons. Heights are those at barriers and
// collectors: the greatest of a run is mostly a fall from the cliff, which no fence has to stop.

import * as d3 from '../figures/d3';
import { element } from './figure';
import { isNumber, number, resultIn, settingText, unitIn } from './format';
import { runs, single } from './run';
import { table } from './tables';

export function cards(parent) {
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
  const of = (name, key, unit) => (run) => {
    const value = (run.statistics[name] || {})[key];
    return isNumber(value) ? [resultIn(unit, value), unitIn(unit)] : null;
  };
  card('Rocks', (run) => run.summary.rocks ? [number(run.summary.rocks.done), run.summary.interrupted ? `of ${number(run.summary.rocks.planned)}` : ''] : null);
  card('Mean runout (plan)', of('runout_xy_m', 'mean', 'm'));
  card('Maximum runout (plan)', of('runout_xy_m', 'maximum', 'm'));
  card('Maximum total kinetic energy', of('max_ke_J', 'maximum', 'J'));
  const names = [...new Set(runs.flatMap((run) => run.barriers.map((b) => b.name)))];
  if (names.length > 0 && names.length <= 2) {
    for (const name of names) {
      card(`Reached ${name}`, (run) => {
        const b = run.barriers.find((other) => other.name === name);
        return b ? [number(b.hits), `hits, ${number(b.passed_above)} above`] : null;
      });
      const percentileAt = (key, unit) => (run) => {
        const b = run.barriers.find((other) => other.name === name);
        const value = (((b || {}).statistics || {})[key] || {percentiles: {}}).percentiles['95'];
        return isNumber(value) ? [resultIn(unit, value), unitIn(unit)] : null;
      };
      card(`95 % total energy at ${name}`, percentileAt('ke_total_J', 'J'));
      card(`95 % height of contact at ${name}`, percentileAt('impact_height_m', 'm'));
    }
  }
}

// Drops the "road.toml:31: warning: " of the command line, which is redundant under this heading.
const warningText = (warning) => (typeof warning === 'string' ? warning : settingText(warning)).replace(/^(?:.*?: )?warning: /, '');

export function warnings(parent) {
  const lines = runs.flatMap((run) => {
    const mark = single ? '' : run.label + ': ';
    const rocks = run.summary.rocks || {};
    const stopped = run.summary.interrupted ? [`The run was interrupted after ${number(rocks.done)} of ${number(rocks.planned)} rocks.`] : [];
    return [...stopped, ...run.warnings.map(warningText), ...(run.summary.notes || []), ...run.notes].map((line) => mark + line);
  });
  if (!lines.length) return element(parent, 'p', 'The run has no warnings.', {class: 'quiet'});
  const note = element(parent, 'div', null, {class: 'note'});
  element(note, 'h4', 'Warnings and notes');
  const list = element(note, 'ul');
  for (const line of lines) element(list, 'li', line);
}

export function endReasons(parent) {
  const reasons = [...new Set(runs.flatMap((run) => Object.keys(run.summary.end_reasons || {})))];
  const countOf = (run, reason) => (run.summary.end_reasons || {})[reason] ?? 0;
  const used = reasons.filter((reason) => runs.some((run) => countOf(run, reason) > 0));
  if (!used.length) return element(parent, 'p', 'The summary has no end reasons.', {class: 'quiet'});
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
