// The drawing of the slope in section with trajectories.

import type { Settings } from '../archive/summary';
import * as d3 from '../figures/d3';
import { axes, legend, sign, type Group, type LegendEntry, type Scale, type Side } from '../figures/plot';
import { tip } from '../figures/tip';
import { choice } from './choice';
import type { PathRow, Rock } from './data';
import { drawing, element, figure } from './figure';
import { axisIn, givenLength, isList, unitIn } from './format';
import type { Over } from './groundBand';
import { clippedGroup } from './mapframe';
import { roundScale, unitsPerMetre } from './mapRoom';
import { drawRocks, rockSigns, shownRows, shownText } from './rocks';
import { firstRun, materialsOf, nameIn, tableOf, type Run } from './run';
import { drawScaleBar, scaleText } from './scaleBar';
import { groundUnder, slope, type Ground, type Slope, type Wall } from './slope';
import { boxOfText } from './textBoxes';
import { travel, type Point } from './travel';

const sectionLeft = 68; // of the frame
const spanOf = ({ u, z }: Slope): Point => [u[1] - u[0], z[1] - z[0]];

/// The denominator of the round scale at which a section fits.
export function sectionScaleIn(of: Slope, width: number, tallest: number): number {
  const [du, dz] = spanOf(of);
  return roundScale(unitsPerMetre(1) * Math.max(du / (width - sectionLeft - 14), dz / tallest));
}

interface SectionFrame {
  side: Side;
  toX: Scale;
  toY: Scale;
  scale: number;
  denominator: number;
}

// A frame with the same round scale on both axes, as large as the width and `tallest` allow. It is no wider than its
// content, so that the legend fits next to it.
function equalFrame(of: Slope, width: number, tallest: number): SectionFrame {
  const [du, dz] = spanOf(of);
  const denominator = sectionScaleIn(of, width, tallest);
  const scale = unitsPerMetre(denominator);
  const room = Math.max(du * scale, Math.min(420, width - sectionLeft - 14));
  const height = Math.max(dz * scale, 110);
  const side = { left: sectionLeft, top: 12, right: sectionLeft + room, bottom: 12 + height };
  const about = ([low, high]: Point, length: number) => [(low + high - length) / 2, (low + high + length) / 2];
  const toX = d3.scaleLinear().domain(about(of.u, room / scale)).range([side.left, side.right]);
  const toY = d3.scaleLinear().domain(about(of.z, height / scale)).range([side.bottom, side.top]);
  return { side, toX, toY, scale, denominator };
}

// Next to the frame if there is room, or else below it. Returns the y of its end.
function drawLegend(svg: Group, side: Side, width: number, entries: readonly LegendEntry[]): number {
  if (width - side.right <= 190) return legend(svg, entries, side.left, side.bottom + 58, side.right) + 12;
  entries.forEach((entry, k) => legend(svg, [entry], side.right + 26, side.top + 12 + 23 * k));
  return Math.max(side.bottom + 46, side.top + 23 * entries.length + 12);
}

// The SVG path through the rows of paths.csv. A flight is a parabola, that is a quadratic Bézier curve whose control
// point is half the flight time along the tangent at departure; other rows are joined by straight lines.
const pathOf =
  ({ toX, toY }: SectionFrame) =>
  ({ rows }: Rock): string => {
    const text = (u: number, z: number) => `${toX(u).toFixed(2)},${toY(z).toFixed(2)}`;
    const speed = ({ vx, vy }: PathRow) => vx * travel.direction[0] + vy * travel.direction[1];
    const parts = rows.map((row, k) => {
      const to = text(travel.along(row), row.z);
      const from = rows[k - 1];
      if (!from) return `M${to}`;
      const half = (row.time - from.time) / 2;
      if (from.state !== 'projectile' || half <= 0) return `L${to}`;
      return `Q${text(travel.along(from) + speed(from) * half, from.z + from.vz * half)} ${to}`;
    });
    return parts.join('');
  };

const materialColour = (run: Run, name: string) => {
  const index = materialsOf(run).findIndex((material) => nameIn(material) === name);
  return index < 0 ? null : `var(--m${index % 6})`;
};

// The material of a segment of a section.
function materialAt({ segments, default: usual }: Settings, segment: number): string | null {
  const own = isList(segments) ? segments[segment] : null;
  const name = own || usual;
  return typeof name === 'string' ? name : null;
}

// Colours the segments of a section by their materials. Returns the names of these.
function drawMaterials(group: Group, { run, points }: Ground, lineOf: (points: Point[]) => string | null): Set<string> {
  const used = new Set<string>();
  const settings = tableOf(run, 'ground');
  points.slice(1).forEach((point, k) => {
    const name = materialAt(settings, k);
    const colour = name === null ? null : materialColour(run, name);
    if (name === null || !colour) return;
    used.add(name);
    const segment = group.append('path').attr('class', 'ground-line').attr('d', lineOf([points[k]!, point]));
    tip(segment.style('stroke', colour).style('stroke-width', 4), () => `Segment ${k + 1}: ${name}`);
  });
  return used;
}

// Draws the ground of runs in 2D. Returns the names of the materials that it shows.
function drawGround(group: Group, { grounds, agree }: Slope, { side, toX, toY }: SectionFrame): Set<string> {
  const line = d3.line<Point>().x(([u]) => toX(u)).y(([, z]) => toY(z));
  const differ = grounds.length > 1 && !agree;
  let used = new Set<string>();
  for (const [k, ground] of grounds.entries()) {
    const { run } = ground;
    const points = [...ground.points];
    const [first, last] = [points[0], points.at(-1)];
    if (!first || !last || (agree && k > 0)) continue;
    const down = `L${toX(last[0])},${side.bottom}L${toX(first[0])},${side.bottom}Z`;
    if (k === 0) group.append('path').attr('class', 'ground').attr('d', `${line(points)}${down}`);
    const edge = group.append('path').attr('class', 'ground-line').attr('d', line(points));
    if (differ) edge.style('stroke', run.colour);
    if (!differ) used = drawMaterials(group, ground, line);
  }
  return used;
}

// Draws the ground under the trajectories of runs in 3D, from the lowest to the highest.
function drawBands(group: Group, { bands }: Slope, { side, toX, toY }: SectionFrame) {
  const line = d3.line<Point>().x(([u]) => toX(u)).y(([, z]) => toY(z));
  for (const [k, { run, band }] of bands.entries()) {
    for (const { u, low, high } of band) {
      const pointsOf = (edge: readonly number[]) => edge.map((z, i): Point => [u[i]!, z]);
      const [below, above] = [pointsOf(low), pointsOf(high)];
      const down = `L${toX(u.at(-1)!)},${side.bottom}L${toX(u[0]!)},${side.bottom}Z`;
      if (k === 0) group.append('path').attr('class', 'ground').attr('d', `${line(below)}${down}`);
      group.append('path').attr('class', 'ground-band').attr('d', `${line([...below, ...[...above].reverse()])}Z`);
      for (const edge of [below, above]) {
        const drawn = group.append('path').attr('class', 'ground-line edge').attr('d', line(edge));
        if (bands.length > 1) drawn.style('stroke', run.colour);
      }
    }
  }
}

// The ground under the selected rocks, on which their bounces can be read.
function drawGroundOfChosen(group: Group, { toX, toY }: SectionFrame) {
  const line = d3.line<Over>().x(({ u }) => toX(u)).y(({ ground }) => toY(ground));
  for (const rock of choice.rocks) {
    if (rock) group.append('path').attr('class', 'ground-of-chosen').attr('d', line(groundUnder(rock)));
  }
}

function drawWall(group: Group, { name, height_m, u, foot, top }: Wall, { side, toX, toY }: SectionFrame) {
  const [x, y] = [toX(top[0]), toY(top[1])];
  const wall = group.append('line').attr('class', 'barrier').attr('x1', toX(u)).attr('y1', toY(foot));
  wall.attr('x2', x).attr('y2', y);
  const text = `${name}, ${givenLength(height_m)}`;
  const isCut = boxOfText(text, 'start', x + 7, y + 2)[2] > side.right;
  const words = group.append('text').attr('class', 'barrier-name halo').attr('text-anchor', isCut ? 'end' : 'start').text(text);
  words.attr('x', isCut ? x - 7 : x + 7).attr('y', y + 2);
}

const materialSign = (name: string): LegendEntry => ({
  text: name,
  draw: (group) => {
    const line = group.append('line').attr('class', 'ground-line').attr('x2', 22);
    line.style('stroke', materialColour(firstRun, name) ?? '').style('stroke-width', 4);
  },
});

const bandSigns = ({ bands }: Slope): LegendEntry[] =>
  bands.length === 0
    ? []
    : [
        { text: 'ground under trajectories', draw: sign.box('ground-band') },
        { text: 'ground under selected rock', draw: sign.line('ground-of-chosen') },
      ];

/// Draws the section into a frame of at most this size. Returns the y of its end.
export function drawSection(svg: Group, of: Slope, width: number, tallest: number, id: string): number {
  const frame = equalFrame(of, width, tallest);
  const { side, toX, toY, scale, denominator } = frame;
  const unit = unitIn('m');
  axes(svg, axisIn('m', toX), axisIn('m', toY), side, { xLabel: `${travel.label} [${unit}]`, yLabel: `z [${unit}]` });
  const inside = clippedGroup(svg, id, side);
  const materials = drawGround(inside, of, frame);
  drawBands(inside, of, frame);
  if (of.bands.length > 0) drawGroundOfChosen(inside, frame);
  drawRocks(inside, pathOf(frame), (place) => [toX(travel.along(place)), toY(place.z)]);
  for (const wall of of.walls) drawWall(inside, wall, frame);
  drawScaleBar(inside, side, scale);
  const end = drawLegend(svg, side, width, [...rockSigns(), ...bandSigns(of), ...[...materials].map(materialSign)]);
  const note = svg.append('text').attr('class', 'map-note').text(`${scaleText(denominator)}, both axes`);
  note.attr('x', side.left).attr('y', end + 8);
  return end + 16;
}

/// Says what the ground of a section of runs in 3D is; empty if it is that of runs in 2D.
export const projectionText = ({ bands }: Slope): string =>
  bands.length > 0 ? 'Trajectories are projected onto the section; the band is the lowest to the highest ground under them.' : '';

function sectionCaption(of: Slope): string {
  return [
    shownText(),
    'Both axes have the same scale; flights are true parabolas. Click a trajectory to select its rock.',
    projectionText(of),
    ...(travel.isX ? [] : [`The mean direction of travel is ${travel.bearing} clockwise from the y axis.`]),
    ...(of.grounds.length + of.bands.length > 0 ? [] : ['The summary has no ground to draw.']),
  ].filter((text) => text !== '').join(' ');
}

export function sectionFigure(parent: Group, width = drawing.wide) {
  const of = slope;
  if (!of) {
    element(parent, 'p', 'The run has neither a section nor trajectories to draw.', { class: 'quiet' });
    return;
  }
  const made = figure(parent, {
    title: 'Section with trajectories',
    label: 'Section of the slope with trajectories; both axes have the same scale',
    caption: sectionCaption(of),
    width,
    rows: shownRows,
    draw: (svg) => drawSection(svg, of, width, 325, 'section-frame'),
  });
  choice.listeners.push(made.redraw);
}
