// Kits at two lines, one behind the other.

import type { Group } from '../figures/plot';
import {
  confidenceText,
  costTitle,
  kitText,
  knownLength,
  lengthHead,
  shareCell,
  sufficesText,
  type DesignRun,
} from './designTexts';
import { element } from './figure';
import { count, isNumber, measured, number } from './format';
import { table, type Row } from './tables';

const mostPairs = 15;

function notesOf(more: number, isStaggered: boolean): string {
  const others = more > 0 ? `${count(more, 'more pair is', 'more pairs are')} in design_pairs.csv. ` : '';
  const needs =
    ' Needs: the overlap that the directions of the rocks ask for at the first line, by the design percentile.';
  return (
    `${others}A rock is caught by a pair if either kit catches it; the second sees the rocks that the first does not catch. ` +
    'Rocks count by their tops; barriers that are built also stop rocks that hit them below that. ' +
    `Of each pair the cheapest kits for what they catch are listed.${isStaggered ? needs : ''}`
  );
}

export function designPairs(parent: Group, { run, design }: DesignRun) {
  const { pairs = [] } = design;
  const shown = pairs.slice(0, mostPairs);
  const [first] = shown;
  if (!first) return;
  const isStaggered = shown.some(({ overlap_m }) => isNumber(overlap_m));
  table(parent, {
    caption: `Two lines, one behind the other, the best first; below each share its ${confidenceText(design)}`,
    head: [
      [
        ...['First line', 'Second line', 'Caught', 'By the first', 'Go on', 'By the second', 'Beyond both'],
        ...(isStaggered ? [lengthHead('Overlap')] : []),
        ...['Suffices', costTitle(run)],
      ],
    ],
    rows: shown.map((pair): Row => [
      { text: pair.first.line, below: kitText(pair.first) },
      { text: pair.second.line, below: kitText(pair.second) },
      shareCell(pair.caught_share),
      number(pair.caught_by_first),
      number(pair.at_second),
      number(pair.caught_by_second),
      number(pair.beside),
      ...(isStaggered
        ? [{ text: knownLength(pair.overlap_m), below: `needs ${knownLength(pair.needs_overlap_m)}` }]
        : []),
      sufficesText(pair),
      measured(pair.cost),
    ]),
    numeric: (column) => column > 1,
    rowClass: (row) => (row === 0 && first.suffices ? 'differs' : ''),
  });
  element(parent, 'p', notesOf(pairs.length - shown.length, isStaggered), { class: 'quiet' });
}
