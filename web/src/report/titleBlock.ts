// The title block of the sheet.

import type { Group } from '../figures/plot';
import { knownFacts, type Fact } from './factsLine';
import { element } from './figure';
import { number } from './format';
import { plan } from './plan';
import { firstRun, paperName, runs, titleBlock } from './run';
import type { Scales } from './sheetArrangement';
import { slope } from './slope';

// In rows; entries that are not given are left out.
function titleBlockRows(scales: Scales): Fact[][] {
  const { number: numberText, author, checked, revision, date, text } = titleBlock;
  const versions = [...new Set(runs.map(({ summary }) => summary.talus?.version))].join(' and ');
  const scale = [...(plan ? [`plan 1:${number(scales.plan)}`] : []), ...(slope ? [`section 1:${number(scales.section)}`] : [])];
  const rows: Fact[][] = [
    [['Title', runs.map(({ name }) => name).join(' and ')]],
    [
      ['Number', numberText],
      ['Revision', revision],
      ['Date', date || firstRun.date.slice(0, 10)],
    ],
    [
      ['Author', author],
      ['Checked', checked],
      ['Program', `Talus ${versions}`],
    ],
    [[`Scale on ${paperName}`, scale.join(', ')]],
    [['', text]],
  ];
  return rows.map(knownFacts).filter((row) => row.length > 0);
}

function addCell(parent: Group, [label, value]: Fact) {
  const cell = element(parent, 'div', null, { class: label === 'Title' ? 'cell title' : 'cell' });
  if (label) element(cell, 'span', label, { class: 'label' });
  element(cell, 'span', value, { class: 'value' });
}

export function titleBlockTable(parent: Group, scales: Scales) {
  const block = element(parent, 'div', null, { class: 'title-block' });
  const logo = firstRun.summary.inputs?.logo;
  const { client, project } = titleBlock;
  if (logo || client || project) {
    const top = element(block, 'div', null, { class: 'row' });
    if (logo) element(top, 'img', null, { src: logo, alt: 'Logo', class: 'logo' });
    const texts = element(top, 'div', null, { class: 'texts' });
    if (client) addCell(texts, ['Client', client]);
    if (project) addCell(texts, ['Project', project]);
  }
  for (const row of titleBlockRows(scales)) {
    const line = element(block, 'div', null, { class: 'row' });
    for (const entry of row) addCell(line, entry);
  }
}
