// The kits of a barrier design, the best first.

import type { Group } from '../figures/plot';
import {
  classText,
  confidenceText,
  costTitle,
  energyHead,
  energyWord,
  givenEnergy,
  isPriced,
  knownLength,
  lengthHead,
  percentText,
  shareCell,
  shareText,
  sufficesText,
  type Design,
  type DesignRun,
  type Kit,
} from './designTexts';
import { element } from './figure';
import { count, givenIn, givenLength, isNumber, measured, number } from './format';
import { tableOf, type Run } from './run';
import { table, type Row } from './tables';

const mostKits = 15;

function bestText(best: Kit, design: Design): string {
  const { line, kit, height_m, energy_J, class: kitClass, caught_share, sure } = best;
  const energy = `${givenEnergy(energy_J)} of ${energyWord(design)} energy${isNumber(kitClass) ? ` (class ${kitClass})` : ''}`;
  const caught = `${shareText(caught_share)}${sure === false ? ' (uncertain)' : ''}`;
  return `${line}, ${kit ? `${kit}, ` : ''}${givenLength(height_m)} high, ${energy}; it catches ${caught}.`;
}

// The best kit; or what limits the kits at each line.
function verdict(parent: Group, { run, design }: DesignRun) {
  const { best, lines, ranking, catch_share } = design;
  const { protect } = tableOf(run, 'design');
  const rocks = typeof protect === 'string' && protect ? `reach ${protect}` : 'reach its line';
  const wanted = `${percentText(catch_share)} of the rocks that ${rocks}`;
  if (best) {
    element(parent, 'p', `Lowest-cost kit that catches ${wanted}: ${bestText(best, design)}`);
    return;
  }
  element(parent, 'p', `None of the given kits catches ${wanted}.`);
  for (const { name } of lines) {
    const limited = ranking.find((kit) => kit.line === name && kit.limit);
    if (limited) element(parent, 'p', `${name}: ${limited.limit}.`);
  }
}

function kitsTable(parent: Group, { run, design }: DesignRun, shown: readonly Kit[]) {
  const { best } = design;
  const name = shown.some(({ kit }) => kit) ? 'Line and kit' : 'Line';
  const order = best ? 'Kits, the best first' : 'Kits, none of which suffices';
  table(parent, {
    caption: `${order}; ${energyWord(design)} energy; below each share its ${confidenceText(design)}`,
    head: [
      [
        ...[name, lengthHead('Height'), energyHead('MEL'), 'Class', 'Caught', 'Too high', 'Too energetic'],
        ...['Beyond the ends', 'Suffices', costTitle(run)],
      ],
    ],
    rows: shown.map((kit): Row => [
      kit.kit ? { text: kit.line, below: kit.kit } : kit.line,
      givenIn('m', kit.height_m),
      givenIn('J', kit.energy_J),
      classText(kit.class),
      shareCell(kit.caught_share),
      number(kit.above),
      number(kit.through),
      number(kit.beside),
      sufficesText(kit),
      measured(kit.cost),
    ]),
    numeric: (column) => column > 0,
    rowClass: (row) => (row === 0 && best ? 'differs' : ''),
  });
}

function netsTable(parent: Group, shown: readonly Kit[]) {
  const isResidual = shown.some(({ residual_height_m }) => isNumber(residual_height_m));
  if (!isResidual && !shown.some(({ needs_clearance_m }) => isNumber(needs_clearance_m))) return;
  table(parent, {
    caption: 'What the nets need behind them, and what an impact leaves of them',
    head: [
      [
        ...['Line and kit', lengthHead('Height'), lengthHead('Needs on plan'), lengthHead('There are')],
        ...[lengthHead('Remains'), 'Rocks below that'],
      ],
    ],
    rows: shown.map((kit): Row => [
      { text: kit.line, below: kit.kit },
      givenIn('m', kit.height_m),
      knownLength(kit.needs_clearance_m),
      knownLength(kit.clearance_m),
      knownLength(kit.residual_height_m),
      shareCell(kit.below_residual_share),
    ]),
    numeric: (column) => column > 0,
  });
  if (!isResidual) return;
  const text =
    'Remains: the height of the kit after an impact at its MEL, at least. Rocks below that: the share of the rocks that ' +
    'would still meet it, whatever their energy; no test says what it stops before it is repaired.';
  element(parent, 'p', text, { class: 'quiet' });
}

function notesOf(run: Run, shown: readonly Kit[], more: number): string {
  const others = more > 0 ? `${count(more, 'more kit is', 'more kits are')} in design_ranking.csv. ` : '';
  const listed = shown.some(({ kit }) => kit) ? '' : 'For each line and height the lowest sufficient energy is listed. ';
  const cost = isPriced(run)
    ? 'The cost is the price per metre of the kit times the length of the line.'
    : 'The cost index is length × height to a power × energy to a power, both from the settings: it compares kits and is ' +
      'not a price.';
  return `${others}A kit catches a rock if it passes the check for that rock. ${listed}${cost}`;
}

export function designRanking(parent: Group, of: DesignRun) {
  const { run, design } = of;
  const shown = design.ranking.slice(0, mostKits);
  verdict(parent, of);
  kitsTable(parent, of, shown);
  if (shown.some(({ sure }) => sure === false)) {
    const text =
      `Uncertain: the required ${percentText(design.catch_share)} is within the ${confidenceText(design)} of the share. ` +
      'Run more rocks, or choose a kit that is certain.';
    element(parent, 'p', text);
  }
  netsTable(parent, shown);
  if (design.free_end_m > 0) {
    const text = `Rocks that cross within ${givenLength(design.free_end_m)} of an end of a line count as beyond the ends.`;
    element(parent, 'p', text, { class: 'quiet' });
  }
  element(parent, 'p', notesOf(run, shown, design.ranking.length - shown.length), { class: 'quiet' });
}
