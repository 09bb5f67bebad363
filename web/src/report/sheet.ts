// The first printed page: plan and section to a round scale, the results, and the title block at the lower right. It is
// not shown on the screen.

import * as d3 from '../figures/d3';
import { cssText } from './cssText';
import { factsList } from './facts';
import { drawing, element, unitNote } from './figure';
import { count, number } from './format';
import { mapRoom, mapScaleIn } from './mapRoom';
import { cards } from './overview';
import { onPaper } from './paper';
import { drawPlan, plan, planCaption } from './plan';
import { metricParts, paperName, papers, runs, single, titleBlock } from './run';
import { choice, drawSection, sectionScaleIn, shownText, slope } from './slope';

const sheetMm = {tall: 267, head: 13, gap: 2};  // of the page between the margins of style.css
const unitsOf = (mm) => mm / drawing.mmOnPaper;

// The paper, and a line below the frame of every page.
export function setPaper() {
  const {client, project, number: numberText, revision} = titleBlock;
  const line = [client, project, numberText, revision && `Rev. ${revision}`, runs.map((run) => run.name).join(' and ')].filter(Boolean).join(' · ');
  element(d3.select('head'), 'style', `@media print { @page { size: ${papers[paperName].size}; @bottom-left { content: ${cssText(line)}; } } body { width: ${papers[paperName].mm}mm; } }`);
  document.body.classList.add(paperName === 'A3' ? 'two-columns' : 'one-column');
}

// The widths of plan and section in drawing units: below each other, or beside each other on a wide page, whichever
// gives the larger scales, by their product.
function arrangement(tall) {
  const wide = unitsOf(papers[paperName].mm), note = 112;  // note: axis, legend and scale below a frame
  const [du, dz] = slope ? [slope.u[1] - slope.u[0], slope.z[1] - slope.z[0]] : [0, 0];
  const both = plan && slope;
  const tries = both ? [] : [{wide: [wide, wide], tall: [tall - note, tall - note]}];
  if (both) {
    for (const share of [0.5, 0.6, 0.7, 0.4, 0.3]) tries.push({wide: [wide, wide], tall: [share * tall - note, (1 - share) * tall - note]});
    if (wide > 2 * drawing.wide) {
      for (const share of [0.5, 0.6, 0.4]) tries.push({wide: [share * wide - 12, (1 - share) * wide - 12], tall: [tall - note, tall - note], isBeside: true});
    }
  }
  const scales = (each) => [plan ? mapScaleIn(mapRoom(each.wide[0], each.tall[0]), plan.views[sheetExtent()]) : 1,
    slope ? sectionScaleIn(each.wide[1], each.tall[1], du, dz) : 1];
  return tries.map((each) => ({...each, scales: scales(each)}))
    .reduce((best, each) => each.scales[0] * each.scales[1] < best.scales[0] * best.scales[1] ? each : best);
}
const sheetExtent = () => plan.canZoom ? 'rocks' : 'terrain';

function sheetDrawings(parent, tall) {
  const place = arrangement(tall);
  const box = element(parent, 'div', null, {class: place.isBeside ? 'drawings beside' : 'drawings'});
  const add = (width, title, draw) => {
    const cell = element(box, 'div', null, {style: `width: ${width * drawing.mmOnPaper}mm`});
    element(cell, 'h4', title);
    const svg = element(cell, 'svg', null, {class: 'drawing', role: 'img', 'aria-label': `${title} on the sheet`});
    const redraw = () => {
      svg.selectAll('*').remove();
      const height = draw(svg);
      svg.attr('viewBox', `0 0 ${width} ${height}`).attr('style', `width: ${width * drawing.mmOnPaper}mm; height: ${height * drawing.mmOnPaper}mm`);
    };
    redraw();
    choice.listeners.push(redraw);
  };
  if (plan) add(place.wide[0], 'Plan with trajectories', (svg) => drawPlan(svg, mapRoom(place.wide[0], place.tall[0], true), sheetExtent(), 'sheet-plan'));
  if (slope) add(place.wide[1], 'Section with trajectories', (svg) => drawSection(svg, place.wide[1], place.tall[1], 'sheet-section'));
  return place;
}

// The entries of the title block, in rows; those that are not given are left out.
function titleBlockRows(scales) {
  const {number: numberText, author, checked, revision, date, text} = titleBlock;
  const versions = [...new Set(runs.map((run) => (run.summary.talus || {}).version))].join(' and ');
  const scale = [plan && `plan 1:${number(scales[0])}`, slope && `section 1:${number(scales[1])}`].filter(Boolean).join(', ');
  return [
    [['Title', runs.map((run) => run.name).join(' and ')]],
    [['Number', numberText], ['Revision', revision], ['Date', date || runs[0].date.slice(0, 10)]],
    [['Author', author], ['Checked', checked], ['Program', `Talus ${versions}`]],
    [[`Scale on ${paperName}`, scale]], [['', text]],
  ].map((row) => row.filter(([, value]) => value)).filter((row) => row.length);
}

function addCell(parent, [label, value]) {
  const cell = element(parent, 'div', null, {class: label === 'Title' ? 'cell title' : 'cell'});
  if (label) element(cell, 'span', label, {class: 'label'});
  element(cell, 'span', value, {class: 'value'});
}

function titleBlockTable(parent, scales) {
  const block = element(parent, 'div', null, {class: 'title-block'});
  const {logo} = runs[0].summary.inputs || {}, {client, project} = titleBlock;
  if (logo || client || project) {
    const top = element(block, 'div', null, {class: 'row'});
    if (logo) element(top, 'img', null, {src: logo, alt: 'Logo', class: 'logo'});
    const texts = element(top, 'div', null, {class: 'texts'});
    if (client) addCell(texts, ['Client', client]);
    if (project) addCell(texts, ['Project', project]);
  }
  for (const row of titleBlockRows(scales)) {
    const line = element(block, 'div', null, {class: 'row'});
    for (const entry of row) addCell(line, entry);
  }
}

// What the drawings show, and the main results.
function sheetNotes(parent) {
  const notes = element(parent, 'div', null, {class: 'notes'});
  factsList(notes);
  cards(notes);
  const of = (text) => element(notes, 'p', text, {class: 'quiet'});
  unitNote(notes, metricParts);
  if (plan) of(planCaption(mapRoom(drawing.wide), sheetExtent()));
  else of(shownText());
  if (slope && slope.grounds.some((g) => !g.section)) of('The section lies along the mean direction of travel.');
  if (runs.some((run) => run.warnings.length)) of(`The run has ${count(runs.reduce((sum, run) => sum + run.warnings.length, 0), 'warning')}; see the next page.`);
}

export function sheet() {
  const node = element(d3.select('#sheet'), 'div', null, {class: 'sheet'});
  const head = element(node, 'div', null, {class: 'sheet-head'});
  element(head, 'p', single ? 'Rockfall analysis' : 'Rockfall analysis · two runs compared', {class: 'kind'});
  element(head, 'h1', runs.map((run) => run.name).join(' and '));
  // The foot is as tall as its contents; the drawings take the rest.
  const foot = element(node, 'div', null, {class: 'sheet-foot'});
  sheetNotes(foot);
  let place = {scales: [1e6, 1e6]};  // as many digits as any scale, to measure the block
  titleBlockTable(foot, place.scales);
  onPaper(() => {
    const mmOf = (each) => each.node().getBoundingClientRect().height * papers[paperName].mm / node.node().getBoundingClientRect().width;
    const tall = sheetMm.tall - sheetMm.gap - mmOf(head) - mmOf(foot);
    place = sheetDrawings(node, unitsOf(tall) - 2 * 24);
  }, `${papers[paperName].mm}mm`);
  foot.raise();
  foot.select('.title-block').remove();
  titleBlockTable(foot, place.scales);
}
