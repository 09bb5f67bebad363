// The first block of the report: cards with the main results, warnings, end reasons. Heights are those at barriers and
// collectors: the greatest of a run is mostly a fall from the cliff, which no fence has to stop.

import { bareWarning } from '../archive/bareWarning';
import * as d3 from '../figures/d3';
import type { Group } from '../figures/plot';
import { element } from './figure';
import { isNumber, number, resultIn, unitIn } from './format';
import { resultsAt, runs, single, type Run } from './run';
import { table, type BodyCell, type Row } from './tables';

// The value of a card in a run, with small type behind it; null: the run has none.
type CardValue = readonly [text: string, small: string] | null;

function card(parent: Group, what: string, valueOf: (run: Run) => CardValue) {
  const values = runs.map((run) => ({ run, value: valueOf(run) }));
  if (values.every(({ value }) => value === null)) return;
  const node = element(parent, 'div', null, { class: 'card' });
  element(node, 'div', what, { class: 'what' });
  for (const { run, value } of values) {
    const line = element(node, 'div', null, { class: 'value' });
    if (!single) line.style('color', run.colour);
    const [text, small] = value ?? ['–', ''];
    element(line, 'span', text);
    if (small) element(line, 'small', ` ${small}`);
  }
}

const valueIn = (unit: string, value: unknown): CardValue =>
  isNumber(value) ? [resultIn(unit, value), unitIn(unit)] : null;

const ofRocks = (quantity: string, figure: string, unit: string) => (run: Run) =>
  valueIn(unit, run.statistics[quantity]?.[figure]);

function rocksOf({ summary: { rocks, interrupted } }: Run): CardValue {
  return rocks ? [number(rocks.done), interrupted ? `of ${number(rocks.planned)}` : ''] : null;
}

function barrierCards(parent: Group, name: string) {
  card(parent, `Reached ${name}`, (run) => {
    const barrier = resultsAt(run, name);
    return barrier ? [number(barrier.hits), `hits, ${number(barrier.passed_above)} above`] : null;
  });
  const percentileOf = (quantity: string, unit: string) => (run: Run) =>
    valueIn(unit, resultsAt(run, name)?.statistics?.[quantity]?.percentiles?.['95']);
  card(parent, `95 % total energy at ${name}`, percentileOf('ke_total_J', 'J'));
  card(parent, `95 % height of contact at ${name}`, percentileOf('impact_height_m', 'm'));
}

const mostBarriersWithCards = 2;

export function cards(parent: Group) {
  const box = element(parent, 'div', null, { class: 'cards' });
  card(box, 'Rocks', rocksOf);
  card(box, 'Mean runout (plan)', ofRocks('runout_xy_m', 'mean', 'm'));
  card(box, 'Maximum runout (plan)', ofRocks('runout_xy_m', 'maximum', 'm'));
  card(box, 'Maximum total kinetic energy', ofRocks('max_ke_J', 'maximum', 'J'));
  const names = [...new Set(runs.flatMap(({ barriers }) => barriers.map(({ name }) => name)))];
  if (names.length <= mostBarriersWithCards) for (const name of names) barrierCards(box, name);
}

function warningsOf({ label, summary, notes }: Run): string[] {
  const { rocks, interrupted } = summary;
  const stopped = `The run was interrupted after ${number(rocks?.done)} of ${number(rocks?.planned)} rocks.`;
  const lines = [
    ...(interrupted ? [stopped] : []),
    ...(summary.warnings ?? []).map(bareWarning),
    ...(summary.notes ?? []),
    ...notes,
  ];
  return lines.map((line) => (single ? line : `${label}: ${line}`));
}

export function warnings(parent: Group) {
  const lines = runs.flatMap(warningsOf);
  if (lines.length === 0) {
    element(parent, 'p', 'The run has no warnings.', { class: 'quiet' });
    return;
  }
  const note = element(parent, 'div', null, { class: 'note' });
  element(note, 'h4', 'Warnings and notes');
  const list = element(note, 'ul');
  for (const line of lines) element(list, 'li', line);
}

// The number of rocks with an end reason, their share of all, and the share as a bar.
function reasonCells({ summary, colour }: Run, reason: string): (string | BodyCell)[] {
  const counts = summary.end_reasons ?? {};
  const rocks = counts[reason] ?? 0;
  const share = rocks / (d3.sum(Object.values(counts)) || 1);
  const draw = (cell: Group) =>
    element(cell, 'span', null, { class: 'meter', style: `width:${(160 * share).toFixed(1)}px` }).style('--run', colour);
  return [number(rocks), `${number(100 * share, 3)} %`, { text: '', draw }];
}

export function endReasons(parent: Group) {
  const occurring = ({ summary }: Run) =>
    Object.entries(summary.end_reasons ?? {}).flatMap(([reason, rocks]) => (rocks > 0 ? [reason] : []));
  const reasons = [...new Set(runs.flatMap(occurring))];
  if (reasons.length === 0) {
    element(parent, 'p', 'The summary has no end reasons.', { class: 'quiet' });
    return;
  }
  table(parent, {
    head: [
      ...(single ? [] : [['', ...runs.map((run) => ({ text: run.label, run, span: 3 }))]]),
      ['Reason', ...runs.flatMap(() => ['Rocks', 'Share', ''])],
    ],
    rows: reasons.map((reason): Row => [reason, ...runs.flatMap((run) => reasonCells(run, reason))]),
    numeric: (column) => column > 0 && column % 3 !== 0,
  });
}
