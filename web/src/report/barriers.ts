// Each barrier and collector: hits, energies and heights.

import type { Group } from '../figures/plot';
import { histogramFigure } from './distributions';
import { element } from './figure';
import { count, isNumber, number, resultIn, unitIn } from './format';
import { hitFigure } from './hitFigure';
import { resultsAt, runs, single, type BarrierResults, type Run } from './run';
import { statisticsTable } from './statistics';
import { table, type Row } from './tables';

// The number of rocks that the figures of a barrier's hits exclude, and the meaning of a negative clearance; null: it
// excludes none.
function passedAboveText(name: string): string | null {
  const shown = runs.flatMap((run) => {
    const barrier = resultsAt(run, name);
    return barrier && barrier.passed_above > 0 ? [{ run, barrier }] : [];
  });
  if (shown.length === 0) return null;
  const rocks = shown.map(({ run, barrier }) => (single ? '' : `${run.label}: `) + count(barrier.passed_above, 'rock'));
  const isBelow = shown.some(({ barrier }) => (barrier.least_clearance_m ?? 0) < 0);
  const ending = isBelow ? '; it is negative if the centre passed above the top and the lower side below it.' : '.';
  return (
    `The figures of the hits exclude ${rocks.join(', ')} that passed with the centre above the top. ` +
    `Clearance is measured from the rock's lower side${ending}`
  );
}

// A collector only records rocks: it has passages instead of hits, and no outcomes.
function countRows(name: string, kind: string): Row[] {
  const results = runs.map((run) => resultsAt(run, name));
  const row = (label: string, value: (barrier: BarrierResults) => number | undefined): Row => [
    label,
    ...results.map((barrier) => number(barrier && value(barrier))),
  ];
  const isCollector = kind === 'collector';
  const outcomes = isCollector ? [] : [...new Set(results.flatMap((barrier) => Object.keys(barrier?.outcomes ?? {})))];
  const [hits, rocks] = isCollector ? ['Passages', 'Rocks that passed'] : ['Hits', 'Rocks that hit'];
  return [
    row(hits, (barrier) => barrier.hits),
    ...(results.some((barrier) => isNumber(barrier?.rocks_hit)) ? [row(rocks, (barrier) => barrier.rocks_hit)] : []),
    ...outcomes.map((word) => row(`Hits: ${word}`, (barrier) => barrier.outcomes?.[word])),
    row('Rocks that passed above', (barrier) => barrier.passed_above),
    [
      { text: 'Minimum clearance above', unit: unitIn('m') },
      ...results.map((barrier) => resultIn('m', barrier?.least_clearance_m, 3)),
    ],
  ];
}

function barrierSection(parent: Group, name: string) {
  const kind = runs.map((run) => resultsAt(run, name)?.kind).find(Boolean) ?? 'barrier';
  element(parent, 'h3', `${kind.charAt(0).toUpperCase()}${kind.slice(1)}: ${name}`);
  const box = element(parent, 'div', null, { class: 'columns' });
  const facts = element(box, 'div');
  table(facts, {
    head: [['', ...(single ? ['Number'] : runs.map((run) => ({ text: run.label, run })))]],
    rows: countRows(name, kind),
    numeric: (column) => column > 0,
  });
  const excluded = passedAboveText(name);
  if (excluded !== null) element(facts, 'p', excluded, { class: 'quiet' });
  hitFigure(box, name);
  histogramFigure(box, {
    title: 'Translational energy at impact',
    quantity: 'Translational kinetic energy',
    column: 'ke_translational_J',
    unit: 'J',
    thing: 'hit',
    of: (run) => resultsAt(run, name)?.histograms?.ke_translational_J,
  });
  histogramFigure(box, {
    title: 'Impact height',
    quantity: 'Impact height of the contact',
    column: 'impact_height_m',
    unit: 'm',
    thing: 'hit',
    of: (run) => resultsAt(run, name)?.histograms?.impact_height_m,
  });
  const quantity = (text: string, unit: string, key: string) => ({
    text,
    unit,
    of: (run: Run) => resultsAt(run, name)?.statistics?.[key],
  });
  statisticsTable(
    parent,
    runs,
    [
      quantity('Translational energy', 'J', 'ke_translational_J'),
      quantity('Total kinetic energy', 'J', 'ke_total_J'),
      quantity('Impact height (contact)', 'm', 'impact_height_m'),
      quantity('Velocity', 'm/s', 'velocity_m_s'),
    ],
    'Descriptive statistics of the hits',
  );
}

export function barrierSections(parent: Group) {
  const names = new Set(runs.flatMap(({ barriers }) => barriers.map(({ name }) => name)));
  for (const name of names) barrierSection(parent, name);
}
