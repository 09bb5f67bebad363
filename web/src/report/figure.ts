// A figure: heading, drawing, caption and buttons to save it. All text is set as text, never as markup, because it
// contains the user's names.

import * as d3 from '../figures/d3';
import { saveCsv, savePng, saveSvg, type Cell } from '../figures/files';
import type { Group, Room } from '../figures/plot';
import type { UnitSystem } from '../units/units';
import { showIn, unitSystem } from './format';

/// Widths in drawing units, about one pixel on a screen. Two half figures and the gap of .columns (style.css) are as wide
/// as a wide one, which fills the width of A4 between its margins. A unit has the same length in both.
export const drawing = { wide: 900, half: 430, mmOnPaper: 184 / 900 };

// Saved figures are named after the run or study of the page, if it is one.
let nameOfPage = '';
export function nameFigures(name: string) {
  nameOfPage = name;
}

export function element(
  parent: Group,
  tag: string,
  text?: string | null,
  attributes: Readonly<Record<string, string | number>> = {},
): Group {
  const made: Group = parent.append(tag);
  if (text !== undefined && text !== null) made.text(text);
  for (const [key, value] of Object.entries(attributes)) made.attr(key, value);
  return made;
}

/// A choice of the units, after which `redraw` draws the page again.
export function unitChoice(parent: Group, redraw: () => void) {
  const select: Group = element(parent, 'label', 'Units ', { class: 'units' }).append('select');
  for (const system of ['metric', 'US customary']) element(select, 'option', system, { value: system });
  select.property('value', unitSystem).on('change', () => {
    showIn(select.property('value') as UnitSystem);
    redraw();
    (d3.select('.units select').node() as HTMLElement).focus();
  });
}

/// On a page that is not metric, says what stays metric.
export function unitNote(parent: Group, metricParts: string) {
  if (unitSystem === 'metric') return;
  const text = `Results are in US customary units; 1 kip·ft is 1,000 ft·lbf. ${metricParts} and saved tables of values are metric, as are all other files.`;
  element(parent, 'p', text, { class: 'quiet unit-note' });
}

interface Drawn {
  /// Draws into an empty drawing and returns the height that it used.
  draw: (svg: Group, width: number) => number;
}
interface Filled {
  /// A figure of web/src/figures, `tall` units high.
  fill: (element: SVGSVGElement, room: Room) => void;
  tall: number;
}
export type FigureOptions = (Drawn | Filled) & {
  title: string;
  caption: string;
  /// For screen readers; the title if it is missing.
  label?: string;
  width?: number;
  /// The table that the CSV button saves; its first row has the column names.
  rows?: () => readonly (readonly (Cell | null | undefined)[])[];
};

export interface MadeFigure {
  node: Group;
  head: Group;
  caption: Group;
  redraw: () => void;
}

export function figure(parent: Group, options: FigureOptions): MadeFigure {
  const { title, caption, label, width = drawing.half, rows } = options;
  const node: Group = parent.append('figure').attr('class', width === drawing.wide ? 'wide' : '');
  const head = element(node, 'div', null, { class: 'figure-head' });
  element(head, 'h4', title);
  const tools = element(head, 'span', null, { class: 'save' });
  const svg = element(node, 'svg', null, { class: 'drawing', role: 'img', 'aria-label': label || title });
  const drawn = svg.node() as SVGSVGElement;
  const note = element(node, 'figcaption', caption);
  const redraw = () => {
    if ('fill' in options) return options.fill(drawn, { width, height: options.tall });
    svg.selectAll('*').remove();
    svg.attr('viewBox', `0 0 ${width} ${options.draw(svg, width)}`);
  };
  redraw();
  const name = title.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'figure';
  const button = (text: string, what: string, action: () => void, more = '') =>
    element(tools, 'button', text, {
      type: 'button',
      title: `Save as ${text}${more}`,
      'aria-label': `Save "${title}" as ${what}${more}`,
    }).on('click', action);
  const fullTitle = nameOfPage ? `${title}: ${nameOfPage}` : title;
  button('SVG', 'SVG drawing', () => saveSvg(name, drawn, fullTitle));
  button('PNG', 'PNG picture', () => void savePng(name, drawn, fullTitle));
  const isMetric = unitSystem === 'metric';
  const csvName = isMetric ? name : `${name}-in-metric-units`;
  if (rows) button('CSV', 'table of values', () => saveCsv(csvName, rows()), isMetric ? '' : ' in metric units');
  return { node, head, caption: note, redraw };
}
