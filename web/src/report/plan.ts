// The plan of a terrain with contours, trajectories and end points.

import type { Relief } from '../archive/summary';
import * as d3 from '../figures/d3';
import { legend, sign, type Group } from '../figures/plot';
import { tip } from '../figures/tip';
import { choice } from './choice';
import { contoursWithin, type Contours } from './contours';
import { drawing, element, figure } from './figure';
import { displayOf, givenLength } from './format';
import { finishMap, fixedBoxes, groundOf, layRelief, mapFrame, noteMap, openMap } from './mapframe';
import { mapRoom, mapWidth, metresPerUnit, viewOf, type MapFrame, type MapRoom, type View } from './mapRoom';
import { hillshade } from './relief';
import { drawRocks, rockSigns, shownRows, shownText } from './rocks';
import { barrierLine, barriersOf, runs, type Run } from './run';
import { boxOfText, isFree, type Box } from './textBoxes';
import type { Point } from './travel';

/// What a plan shows: the rocks with the barriers, or the whole terrain.
export type Extent = 'rocks' | 'terrain';

export interface Plan {
  /// The runs in 3D, of which there is at least one.
  spatial: readonly Run[];
  first: Run;
  /// Of the first run that has one, with its picture.
  relief: { heights: Relief; picture: string } | null;
  views: Record<Extent, View>;
  /// What the plan shows first, and whether there is another extent to see.
  opens: Extent;
  canZoom: boolean;
  /// Contours by the extent that a frame shows; kept, because they take a while.
  contours: Map<string, Contours>;
}

const pointOf = ({ x, y }: { x: number; y: number }): Point => [x, y];
const shownPoints = (run: Run): Point[] => [
  ...run.rocks.flatMap(({ rows }) => rows.map(pointOf)),
  ...run.endpoints.map(pointOf),
  ...barriersOf(run).flatMap(barrierLine),
];
const cornersOf = ({ x0, y0, cell_m, columns, rows }: Relief): Point[] => [
  [x0, y0],
  [x0 + (columns - 1) * cell_m, y0 + (rows - 1) * cell_m],
];

// Whether the rocks cover so little of the terrain that the plan opens zoomed in on them.
function coversLittle(rocks: View, terrain: View): boolean {
  const room = mapRoom(drawing.wide);
  return metresPerUnit(room, terrain) > 1.6 * metresPerUnit(room, rocks);
}

/// Null if there is no run in 3D to draw.
export const plan = ((): Plan | null => {
  const spatial = runs.filter(({ isSection }) => !isSection);
  const [first] = spatial;
  const heights = spatial.find(({ terrain }) => terrain.relief)?.terrain.relief ?? null;
  const ofRocks = spatial.flatMap(shownPoints);
  const ofTerrain = spatial.flatMap(({ terrain }) => terrain.bounds ?? []).map(([x, y]): Point => [x, y]);
  const all = [...ofRocks, ...ofTerrain, ...(heights ? cornersOf(heights) : [])];
  if (!first || all.length === 0) return null;
  const views = { rocks: viewOf(ofRocks, 0.15), terrain: viewOf(all, 0.01) };
  const canZoom = ofRocks.length > 0 && coversLittle(views.rocks, views.terrain);
  const relief = heights && { heights, picture: hillshade(heights) };
  return { spatial, first, relief, views, opens: canZoom ? 'rocks' : 'terrain', canZoom, contours: new Map() };
})();

function contoursOf({ relief, contours }: Plan, shown: View): Contours {
  const key = JSON.stringify([shown, displayOf('m')]);
  const made = contours.get(key) ?? (relief ? contoursWithin(relief.heights, shown) : { interval: 0, lines: [] });
  contours.set(key, made);
  return made;
}

// The names keep clear of the boxes in `taken`, to which theirs are added.
function drawContours(inside: Group, { interval, lines: contours }: Contours, frame: MapFrame, taken: Box[]) {
  const { toX, toY, shown } = frame;
  const line = d3.line<Point>().x(([x]) => toX(x)).y(([, y]) => toY(y));
  const named: Point[] = []; // places of names, kept apart from each other
  const isShown = ([x, y]: Point) => x > shown.x[0] && x < shown.x[1] && y > shown.y[0] && y < shown.y[1];
  for (const { level, lines } of contours) {
    const isMain = Math.round(level / interval) % 5 === 0;
    const path = inside.append('path').attr('class', isMain ? 'contour main' : 'contour');
    path.attr('d', lines.map((each) => line(each)).join(''));
    const text = givenLength(level);
    tip(path, () => `z = ${text}`);
    const longest = lines.map((each) => each.filter(isShown)).reduce((a, b) => (b.length > a.length ? b : a), []);
    const place = longest[Math.floor(longest.length * 0.12)];
    if (!isMain || longest.length < 8 || !place) continue;
    const [x, y] = [toX(place[0]), toY(place[1]) + 4];
    const box = boxOfText(text, 'middle', x, y);
    if (!isFree(box, taken) || named.some((other) => Math.hypot(other[0] - x, other[1] - y) < 46)) continue;
    named.push([x, y]);
    taken.push(box);
    const name = inside.append('text').attr('class', 'contour-name halo').attr('text-anchor', 'middle').text(text);
    name.attr('x', x).attr('y', y);
  }
}

const planFrame = (of: Plan, room: MapRoom, extent: Extent) => mapFrame(room, of.views[extent], groundOf(of.spatial, of.views[extent]));

/// Draws one of the extents of the plan. Returns the y of its end.
export function drawPlan(svg: Group, of: Plan, room: MapRoom, extent: Extent, id: string): number {
  const frame = planFrame(of, room, extent);
  const { side, toX, toY } = frame;
  const contours = contoursOf(of, frame.shown);
  const inside = openMap(svg, id, frame);
  const taken = fixedBoxes(frame);
  if (of.relief) {
    layRelief(inside, frame, of.relief.heights, of.relief.picture);
    drawContours(inside, contours, frame, taken);
  }
  const pathOf = ({ rows }: { rows: readonly { x: number; y: number }[] }) =>
    `M${rows.map(({ x, y }) => `${toX(x).toFixed(2)},${toY(y).toFixed(2)}`).join('L')}`;
  drawRocks(inside, pathOf, ({ x, y }) => [toX(x), toY(y)]);
  finishMap(inside, frame, of.first, of.spatial.flatMap(barriersOf), taken);
  const signs = [...rockSigns(), ...(contours.interval > 0 ? [{ text: 'contour', draw: sign.line('contour main') }] : [])];
  const y = side.bottom + 58;
  const lowest = legend(svg, signs, side.left, y, room.isBeside ? 0.6 * room.width : room.width);
  return noteMap(svg, room, frame, { run: of.first, y, lowest });
}

export function planCaption(of: Plan, room: MapRoom, extent: Extent): string {
  const { interval } = contoursOf(of, planFrame(of, room, extent).shown);
  const relief = of.relief
    ? `Contours every ${givenLength(interval)}; relief lit from the upper left.`
    : 'The summary has no relief to draw.';
  const flat = runs.find(({ isSection }) => isSection);
  return `${shownText()}${relief}${flat ? ` ${flat.label} is two-dimensional and drawn at y = 0.` : ''}`;
}

/// Returns the figure's width; null if there is no run in 3D to draw.
export function planFigure(parent: Group): number | null {
  const of = plan;
  if (!of) return null;
  let shown = of.opens;
  const width = mapWidth(of.views[shown]);
  const room = mapRoom(width);
  const made = figure(parent, {
    title: 'Plan with trajectories',
    label: 'Plan of the terrain with contours, trajectories and end points',
    caption: planCaption(of, room, shown),
    width,
    rows: shownRows,
    draw: (svg) => drawPlan(svg, of, room, shown, 'plan-frame'),
  });
  choice.listeners.push(made.redraw);
  if (!of.canZoom) return width;
  const other = () => (shown === 'rocks' ? 'Show the whole terrain' : 'Show the rocks');
  const zoom = element(made.head.insert('span', '.save').attr('class', 'zoom'), 'button', other(), { type: 'button' });
  zoom.on('click', () => {
    shown = shown === 'rocks' ? 'terrain' : 'rocks';
    zoom.text(other());
    made.caption.text(planCaption(of, room, shown));
    made.redraw();
  });
  return width;
}
