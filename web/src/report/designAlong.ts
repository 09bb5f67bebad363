// Rocks and percentiles of energy, velocity and height along a line, section by section.

import * as d3 from '../figures/d3';
import { axes, legend, sign, type Group, type Scale } from '../figures/plot';
import { tip } from '../figures/tip';
import {
  designQuantities,
  percentilesIn,
  percentileText,
  percentText,
  shareRange,
  shareText,
  stretchText,
  type DesignRun,
  type Line,
  type Percentile,
  type Section,
} from './designTexts';
import { drawing, figure } from './figure';
import { axisIn, count, inSavedUnit, isNumber, unitIn } from './format';
import { single } from './run';

const panels = { left: 82, right: 14, top: 26, gap: 50, rocksTall: 70, tall: 130 };
const colourOf = (k: number) => `var(--m${(k + 2) % 6})`;

// A percentile of a section, the k-th of them.
interface Mark {
  section: Section;
  name: string;
  k: number;
  of: NonNullable<Percentile>;
}
const marksOf = ({ sections }: Line, key: string): Mark[] =>
  sections.flatMap((section) =>
    Object.entries(section.percentiles[key] ?? {}).map(([name, of], k) => ({ section, name, k, of })),
  );

function sectionText(section: Section): string {
  const { rocks, share } = section;
  const text = `${stretchText(section)}\n${count(rocks, 'rock')}, ${shareText(share)} of all\n`;
  return share ? text + shareRange(share) : text;
}

function drawRocks(svg: Group, x: Scale, y: Scale, { sections }: Line, colour: string) {
  const bars = svg
    .append('g')
    .style('--run', colour)
    .selectAll('rect')
    .data(sections.filter(({ rocks }) => rocks > 0))
    .enter()
    .append('rect')
    .attr('class', 'bar')
    .attr('x', ({ from_m }) => x(from_m))
    .attr('width', ({ from_m, to_m }) => Math.max(x(to_m) - x(from_m) - 0.5, 1))
    .attr('y', ({ rocks }) => y(rocks))
    .attr('height', ({ rocks }) => y(0) - y(rocks));
  tip(bars, sectionText);
}

function drawMarks(svg: Group, x: Scale, y: Scale, marks: readonly Mark[], unit: string) {
  const widthOf = ({ section: { from_m, to_m } }: Mark) => Math.max(x(to_m) - x(from_m), 1);
  const lowOf = ({ of: [value, low] }: Mark) => y(isNumber(low) ? low : value);
  const highOf = ({ of: [value, , high] }: Mark) => y(isNumber(high) ? high : value);
  svg
    .append('g')
    .selectAll('rect')
    .data(marks.filter(({ of: [, low, high] }) => isNumber(low) || isNumber(high)))
    .enter()
    .append('rect')
    .attr('class', 'band')
    .style('--run', ({ k }) => colourOf(k))
    .attr('x', ({ section }) => x(section.from_m))
    .attr('width', widthOf)
    .attr('y', highOf)
    .attr('height', (mark) => lowOf(mark) - highOf(mark));
  const steps = svg
    .append('g')
    .selectAll('line')
    .data(marks)
    .enter()
    .append('line')
    .attr('class', 'step')
    .style('--run', ({ k }) => colourOf(k))
    .attr('x1', ({ section }) => x(section.from_m))
    .attr('x2', (mark) => x(mark.section.from_m) + widthOf(mark))
    .attr('y1', ({ of: [value] }) => y(value))
    .attr('y2', ({ of: [value] }) => y(value));
  tip(
    steps,
    ({ section, name, of }) =>
      `${stretchText(section)}, ${count(section.rocks, 'rock')}\np${name}: ${percentileText(of, unit)}`,
  );
}

// Panels below each other: the number of rocks, then for each quantity its percentiles with confidence intervals.
function drawAlong(svg: Group, width: number, { run, design }: DesignRun, line: Line, names: readonly string[]): number {
  const [left, right] = [panels.left, width - panels.right];
  const x = d3.scaleLinear().domain([0, line.length_m]).range([left, right]);
  let { top } = panels;
  const panel = (values: readonly number[], unit: string, title: string, tall: number, xLabel = ''): Scale => {
    const side = { left, right, top, bottom: top + tall };
    const y = d3
      .scaleLinear()
      .domain([0, (d3.max(values) || 1) * 1.06])
      .range([side.bottom, side.top]);
    axes(svg, axisIn('m', x), axisIn(unit, y), side, { xLabel, yLabel: '', yTicks: 4 });
    svg
      .append('text')
      .attr('class', 'axis-label')
      .attr('x', left)
      .attr('y', side.top - 8)
      .text(title);
    top = side.bottom + panels.gap;
    return y;
  };
  const rocks = line.sections.map((section) => section.rocks);
  drawRocks(svg, x, panel(rocks, '', 'Rocks', panels.rocksTall), line, run.colour);
  const quantities = designQuantities(design);
  quantities.forEach(({ key, text, unit }, k) => {
    const marks = marksOf(line, key);
    const values = marks.flatMap(({ of: [value, , high] }) => [value, high]).filter(isNumber);
    const xLabel = k === quantities.length - 1 ? `Distance along the line on plan [${unitIn('m')}]` : '';
    drawMarks(svg, x, panel(values, unit, `${text} [${unitIn(unit)}]`, panels.tall, xLabel), marks, unit);
  });
  const entries = names.map((name, k) => ({ text: `percentile ${name}`, draw: sign.line('step', colourOf(k)) }));
  return legend(svg, entries, left, top + 14, right) + 14;
}

function rowsOf({ design }: DesignRun, { sections }: Line, names: readonly string[]) {
  const columns = designQuantities(design).flatMap(({ key, unit }) =>
    names.flatMap((name) => [0, 1, 2].map((end) => ({ key, unit, name, end }))),
  );
  const ends = ['', ' low', ' high'];
  return [
    ['from_m', 'to_m', 'rocks', 'share', ...columns.map(({ key, name, end }) => `${key.replace(/_J$/, '_kJ')} p${name}${ends[end]}`)],
    ...sections.map(({ from_m, to_m, rocks, share, percentiles }) => [
      ...[from_m, to_m, rocks, share?.value],
      ...columns.map(({ key, unit, name, end }) => inSavedUnit(unit, percentiles[key]?.[name]?.[end])),
    ]),
  ];
}

export function alongFigure(parent: Group, of: DesignRun, line: Line) {
  const crossed = line.sections.find(({ rocks }) => rocks > 0);
  const names = crossed ? percentilesIn(crossed) : [];
  const { run, design } = of;
  figure(parent, {
    title: single ? `Along ${line.name}` : `Along ${line.name} · ${run.label}`,
    label: `Rocks and percentiles of energy, velocity and height along ${line.name}`,
    width: drawing.wide,
    caption:
      `Each step is a section of the line. Lines: percentiles. Shaded: their ${percentText(design.confidence)} confidence ` +
      'intervals, which have no upper end where a section has too few rocks.',
    draw: (svg, width) => drawAlong(svg, width, of, line, names),
    rows: () => rowsOf(of, line, names),
  });
}
