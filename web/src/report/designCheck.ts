// What the check of a standard requires of a kit at each line, its factors, and the room behind the lines.

import * as d3 from '../figures/d3';
import type { Group } from '../figures/plot';
import {
  classText,
  energyHead,
  energyWord,
  knownLength,
  lengthHead,
  needsCells,
  stretchText,
  type Design,
  type Line,
} from './designTexts';
import { element } from './figure';
import { givenIn, givenLength, isNumber, number, resultIn, unitIn } from './format';
import { table, type Row } from './tables';

// The maximum of each requirement over the sections.
function worstCells({ sections }: Line): string[] {
  const needs = sections.map((section) => section.needs).filter((each) => each !== null);
  const worst = (key: 'energy_J' | 'class' | 'height_m') => d3.max(needs, (each) => each[key]);
  return [resultIn('J', worst('energy_J')), classText(worst('class')), knownLength(worst('height_m'))];
}

function requirements(parent: Group, design: Design) {
  const requirementsOf = design.standard
    ? `Requirements of the check of ${design.standard}`
    : 'Requirements without the factors of a standard';
  const needs = () => [energyHead('MEL'), 'Class', lengthHead('Height')];
  table(parent, {
    caption: `${requirementsOf}, by ${energyWord(design)} energy`,
    head: [
      [
        '',
        { text: `By percentile ${number(design.design_percentile)}`, span: 3 },
        { text: 'By the upper ends of its interval', span: 3 },
        { text: 'Worst section', span: 3 },
      ],
      ['Line', ...needs(), ...needs(), ...needs()],
    ],
    rows: design.lines.map((line): Row => [
      line.name,
      ...needsCells(line.needs),
      ...needsCells(line.needs_at_upper_end),
      ...worstCells(line),
    ]),
    numeric: (column) => column > 0,
  });
}

// The section with the least room behind it.
function narrowestOf({ sections }: Line) {
  const least = Math.min(...sections.map(({ clearance_m }) => clearance_m ?? Infinity));
  return sections.find(({ clearance_m }) => clearance_m === least);
}

function elongations(parent: Group, { lines }: Design) {
  const known = lines.filter(({ clearance_m }) => isNumber(clearance_m));
  if (known.length === 0) return;
  table(parent, {
    caption: 'Distance on plan to what is protected, and the elongation that a kit may have there at most',
    head: [['Line', lengthHead('Distance'), lengthHead('Elongation at most'), 'Narrowest section']],
    rows: known.map((line): Row => {
      const narrowest = narrowestOf(line);
      const elongation = isNumber(line.most_elongation_m) ? knownLength(line.most_elongation_m) : 'needs elongation_factor';
      return [line.name, knownLength(line.clearance_m), elongation, narrowest ? stretchText(narrowest) : '–'];
    }),
    numeric: (column) => column === 1 || column === 2,
  });
}

function checkText({ standard, factors }: Design): string {
  const { level, clearance_m, clears_half_the_block, block_mass_kg } = factors;
  const clearance = `Upper clearance ${givenLength(clearance_m)}${clears_half_the_block ? ' or half the block' : ''}. `;
  const block = isNumber(block_mass_kg)
    ? `Energy and size in the check are those of a design block of ${givenIn('kg', block_mass_kg)} ${unitIn('kg')}. `
    : '';
  return (
    `${standard ? `The kit's energy is its ${level}. ${clearance}` : ''}${block}` +
    'Each column of the worst section has the maximum of all sections. Classes are those of EAD 340059-00-0106; class 8 is ' +
    'above 4,500 kJ. Foundations and simultaneous impacts of several rocks are not checked.'
  );
}

export function designCheck(parent: Group, design: Design) {
  requirements(parent, design);
  elongations(parent, design);
  element(parent, 'p', checkText(design), { class: 'quiet' });
}

/// Every factor of the check with its source, and what could not be read there.
export function designFactors(parent: Group, { standard, applied_factors, standard_not_read }: Design) {
  if (!standard || !applied_factors) return;
  table(parent, {
    caption: `Factors of the check of ${standard}`,
    head: [['Symbol', 'Multiplies', 'Value', 'Source', 'Could not be read there']],
    rows: applied_factors.map(({ symbol, key, multiplies, value, source, not_read }): Row => [
      { text: symbol, below: key },
      multiplies,
      number(value),
      source,
      not_read || '–',
    ]),
    numeric: (column) => column === 2,
  });
  if (standard_not_read) element(parent, 'p', `${standard_not_read}.`, { class: 'quiet' });
}
