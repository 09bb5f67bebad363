// Barrier design: demands of the rocks along each line, requirements of the check, and the ranked kits.

import type { Group } from '../figures/plot';
import { alongFigure } from './designAlong';
import { designCheck, designFactors } from './designCheck';
import { designPairs } from './designPairs';
import { designRanking } from './designRanking';
import {
  confidenceText,
  designQuantities,
  lengthHead,
  percentileCell,
  percentilesIn,
  shareCell,
  type Design,
  type DesignRun,
} from './designTexts';
import { element } from './figure';
import { givenIn, number, unitIn } from './format';
import { runs, single } from './run';
import { table, type Row } from './tables';

/// Runs with a design.
export const designsOf = (): DesignRun[] =>
  runs.flatMap((run) => (run.summary.design ? [{ run, design: run.summary.design }] : []));

// The rocks at each line, one row for each percentile.
function demands(parent: Group, design: Design) {
  const quantities = designQuantities(design);
  const names = [...new Set(design.lines.flatMap(percentilesIn))];
  const columns = quantities.map(({ text, unit }) => ({ text, unit: unitIn(unit) }));
  const rows = design.lines.flatMap((line) =>
    (line.rocks > 0 ? names : ['–']).map((name, k): Row => {
      const ofLine = [
        line.name,
        line.length_m ? givenIn('m', line.length_m, 5) : '–',
        number(line.rocks),
        shareCell(line.share),
      ];
      const percentiles = quantities.map(({ key, unit }) => percentileCell(line.percentiles[key]?.[name], unit));
      return [...(k === 0 ? ofLine : ofLine.map(() => '')), name, ...percentiles];
    }),
  );
  table(parent, {
    caption: `Rocks that cross each line; below each value its ${confidenceText(design)}, from sampling alone`,
    head: [['Line', lengthHead('Length'), 'Rocks', 'Share of all', 'Percentile', ...columns]],
    rows,
    numeric: (column) => column > 0,
  });
}

export function designSections(parent: Group) {
  for (const of of designsOf()) {
    const { run, design } = of;
    if (!single) element(parent, 'h3', run.label);
    demands(parent, design);
    designCheck(parent, design);
    designFactors(parent, design);
    designRanking(parent, of);
    designPairs(parent, of);
    const drawn = design.lines.filter(({ sections, rocks }) => sections.length > 1 && rocks > 0);
    for (const line of drawn) alongFigure(parent, of, line);
  }
}
