// The first printed page: plan and section to a round scale, the results, and the title block at the lower right. It is
// not shown on the screen.

import * as d3 from '../figures/d3';
import type { Group } from '../figures/plot';
import { cssText } from './cssText';
import { choice } from './choice';
import { factsList } from './facts';
import { drawing, element, unitNote } from './figure';
import { count } from './format';
import { mapRoom } from './mapRoom';
import { cards } from './overview';
import { onPaper } from './paper';
import { drawPlan, plan, planCaption } from './plan';
import { shownText } from './rocks';
import { metricParts, paperName, papers, runs, single, titleBlock } from './run';
import { drawSection, projectionText } from './sectionFigure';
import { arrangementIn, unitsOf, type Scales } from './sheetArrangement';
import { slope } from './slope';
import { titleBlockTable } from './titleBlock';

const sheetMm = { tall: 267, gap: 2 }; // of the page between the margins of style.css
const paper = papers[paperName];
const isNotEmpty = (text: string) => text !== '';

/// The paper, and a line below the frame of every page.
export function setPaper() {
  const { client, project, number: numberText, revision } = titleBlock;
  const names = runs.map(({ name }) => name).join(' and ');
  const line = [client, project, numberText, revision && `Rev. ${revision}`, names].filter(isNotEmpty).join(' · ');
  const page = `@page { size: ${paper.size}; @bottom-left { content: ${cssText(line)}; } }`;
  element(d3.select('head'), 'style', `@media print { ${page} body { width: ${paper.mm}mm; } }`);
  document.body.classList.add(paperName === 'A3' ? 'two-columns' : 'one-column');
}

// A drawing of this width in drawing units, which `draw` fills, returning its height.
function addDrawing(box: Group, width: number, title: string, draw: (svg: Group) => number) {
  const mm = (units: number) => `${units * drawing.mmOnPaper}mm`;
  const cell = element(box, 'div', null, { style: `width: ${mm(width)}` });
  element(cell, 'h4', title);
  const svg = element(cell, 'svg', null, { class: 'drawing', role: 'img', 'aria-label': `${title} on the sheet` });
  const redraw = () => {
    svg.selectAll('*').remove();
    const height = draw(svg);
    svg.attr('viewBox', `0 0 ${width} ${height}`).attr('style', `width: ${mm(width)}; height: ${mm(height)}`);
  };
  redraw();
  choice.listeners.push(redraw);
}

// Returns the scales of the drawings.
function sheetDrawings(parent: Group, tall: number): Scales {
  const { plan: ofPlan, section: ofSection, isBeside, scales } = arrangementIn(tall);
  const box = element(parent, 'div', null, { class: isBeside ? 'drawings beside' : 'drawings' });
  const [shownPlan, shownSlope] = [plan, slope];
  if (shownPlan) {
    const room = mapRoom(ofPlan.wide, ofPlan.tall, true);
    addDrawing(box, ofPlan.wide, 'Plan with trajectories', (svg) => drawPlan(svg, shownPlan, room, shownPlan.opens, 'sheet-plan'));
  }
  if (shownSlope) {
    const { wide, tall: tallest } = ofSection;
    addDrawing(box, wide, 'Section with trajectories', (svg) => drawSection(svg, shownSlope, wide, tallest, 'sheet-section'));
  }
  return scales;
}

// What the drawings show, and the main results.
function sheetNotes(parent: Group) {
  const notes = element(parent, 'div', null, { class: 'notes' });
  factsList(notes);
  cards(notes);
  const note = (text: string) => element(notes, 'p', text, { class: 'quiet' });
  unitNote(notes, metricParts);
  note(plan ? planCaption(plan, mapRoom(drawing.wide), plan.opens) : shownText());
  if (slope && projectionText(slope)) note(projectionText(slope));
  const warnings = runs.reduce((sum, { summary }) => sum + (summary.warnings?.length ?? 0), 0);
  if (warnings > 0) note(`The run has ${count(warnings, 'warning')}; see the next page.`);
}

export function sheet() {
  const node = element(d3.select('#sheet'), 'div', null, { class: 'sheet' });
  const head = element(node, 'div', null, { class: 'sheet-head' });
  element(head, 'p', single ? 'Rockfall analysis' : 'Rockfall analysis · two runs compared', { class: 'kind' });
  element(head, 'h1', runs.map(({ name }) => name).join(' and '));
  // The foot is as tall as its contents; the drawings take the rest.
  const foot = element(node, 'div', null, { class: 'sheet-foot' });
  sheetNotes(foot);
  let scales: Scales = { plan: 1e6, section: 1e6 }; // as many digits as any scale, to measure the block
  titleBlockTable(foot, scales);
  onPaper(() => {
    const boxOf = (each: Group) => (each.node() as HTMLElement).getBoundingClientRect();
    const mmOf = (each: Group) => (boxOf(each).height * paper.mm) / boxOf(node).width;
    const tall = sheetMm.tall - sheetMm.gap - mmOf(head) - mmOf(foot);
    scales = sheetDrawings(node, unitsOf(tall) - 2 * 24);
  }, `${paper.mm}mm`);
  foot.raise();
  foot.select('.title-block').remove();
  titleBlockTable(foot, scales);
}
