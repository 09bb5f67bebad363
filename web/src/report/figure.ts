// A figure: heading, drawing, caption and buttons to save it. All text is set as text, never as markup, because it
// contains the user's names.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';
import { showIn, unitSystem } from './format';

// Widths in drawing units, about one pixel on a screen. Two half figures and the gap of .columns (style.css) are as wide
// as a wide one, which fills the width of A4 between its margins. A unit has the same length in both.
export const drawing = {wide: 900, half: 430, mmOnPaper: 184 / 900};

// Saved figures are named after the run or study of the page, if it is one.
let nameOfPage = '';
export function nameFigures(name) {
  nameOfPage = name;
}

export function element(parent, tag, text, attributes = {}) {
  const made = parent.append(tag);
  if (text !== undefined && text !== null) made.text(text);
  for (const [key, value] of Object.entries(attributes)) made.attr(key, value);
  return made;
}

// A choice of the units, after which `redraw` draws the page again.
export function unitChoice(parent, redraw) {
  const select = element(parent, 'label', 'Units ', {class: 'units'}).append('select');
  for (const system of ['metric', 'US customary']) element(select, 'option', system, {value: system});
  select.property('value', unitSystem).on('change', function () {
    showIn(this.value);
    redraw();
    d3.select('.units select').node().focus();
  });
}

// On a page that is not metric, says what stays metric.
export function unitNote(parent, metricParts) {
  if (unitSystem === 'metric') return;
  element(parent, 'p', `Results are in US customary units; 1 kip·ft is 1,000 ft·lbf. ${metricParts} and saved tables of values are metric, as are all other files.`, {class: 'quiet unit-note'});
}

// Returns {node, head, caption, redraw}. A figure of web/src/figures is drawn by `fill(element, room)` into an area
// `tall` units high, any other by `draw(svg, width)`, which returns the height it used. `rows()` returns the table that
// the CSV button saves; its first row has the column names.
export function figure(parent, {title, caption, label, width = drawing.half, tall, fill, draw, rows}) {
  const node = parent.append('figure').attr('class', width === drawing.wide ? 'wide' : '');
  const head = element(node, 'div', null, {class: 'figure-head'});
  element(head, 'h4', title);
  const tools = element(head, 'span', null, {class: 'save'});
  const svg = element(node, 'svg', null, {class: 'drawing', role: 'img', 'aria-label': label || title});
  const note = element(node, 'figcaption', caption);
  const redraw = () => {
    if (fill) return void fill(svg.node(), {width, height: tall});
    svg.selectAll('*').remove();
    const height = draw(svg, width);
    svg.attr('viewBox', `0 0 ${width} ${height}`);
  };
  redraw();
  const name = title.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'figure';
  const button = (text, what, action, more = '') =>
    element(tools, 'button', text, {type: 'button', title: `Save as ${text}${more}`, 'aria-label': `Save "${title}" as ${what}${more}`}).on('click', action);
  const fullTitle = nameOfPage ? `${title}: ${nameOfPage}` : title;
  button('SVG', 'SVG drawing', () => figures.saveSvg(name, svg.node(), fullTitle));
  button('PNG', 'PNG picture', () => figures.savePng(name, svg.node(), fullTitle));
  const isMetric = unitSystem === 'metric';
  if (rows) button('CSV', 'table of values', () => figures.saveCsv(isMetric ? name : `${name}-in-metric-units`, rows()), isMetric ? '' : ' in metric units');
  return {node, head, caption: note, redraw};
}
