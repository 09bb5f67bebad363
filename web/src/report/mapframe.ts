// The frame of a map: coordinates, relief, scale and the names on it.

import type { Relief, Settings } from '../archive/summary';
import * as d3 from '../figures/d3';
import { axes, type Group, type Range, type Side } from '../figures/plot';
import { drawBarriersOnPlan } from './barrierNames';
import { crsText } from './crs';
import { mapScaleIn, unitsPerMetre, type MapFrame, type MapRoom, type View } from './mapRoom';
import { tableOf, type Run } from './run';
import { cornerBoxes, drawNorthArrow, drawScaleBar, scaleText } from './scaleBar';
import type { Box } from './textBoxes';
import type { Point } from './travel';

// Extends the interval [a, b] into [low, high] about its centre, up to a length.
function extend([a, b]: Range, length: number, [low, high]: Range): Range {
  const [first, last] = [Math.min(a, low), Math.max(b, high)];
  if (last - first <= length) return [first, last];
  const from = Math.min(Math.max((a + b - length) / 2, first), last - length);
  return [from, from + length];
}

/// The extent of the view and of the terrain of some runs.
export function groundOf(shown: readonly Run[], view: View): View {
  const corners = shown.flatMap(({ terrain }) => terrain.bounds ?? []);
  const around = ([low, high]: Range, values: readonly number[]): Range => [Math.min(low, ...values), Math.max(high, ...values)];
  return { x: around(view.x, corners.map(([x]) => x)), y: around(view.y, corners.map(([, y]) => y)) };
}

/// The view and as much of the surrounding ground as fits; x and y have the same scale.
export function mapFrame(room: MapRoom, view: View, ground: View): MapFrame {
  const { left, across, tallest, fills } = room;
  const denominator = mapScaleIn(room, view);
  const scale = unitsPerMetre(denominator);
  const x = extend(view.x, across / scale, ground.x);
  const y = extend(view.y, Math.max(view.y[1] - view.y[0], (fills ? tallest : 0.3 * across) / scale), ground.y);
  const side = { left, top: 12, right: left + (x[1] - x[0]) * scale, bottom: 12 + (y[1] - y[0]) * scale };
  const toX = d3.scaleLinear().domain(x).range([side.left, side.right]);
  const toY = d3.scaleLinear().domain(y).range([side.bottom, side.top]);
  return { side, scale, denominator, shown: { x, y }, toX, toY };
}

/// A group clipped to a frame.
export function clippedGroup(svg: Group, id: string, { left, right, top, bottom }: Side): Group {
  const clip = svg.append('clipPath').attr('id', id).append('rect').attr('x', left).attr('y', top);
  clip.attr('width', right - left).attr('height', bottom - top);
  return svg.append('g').attr('clip-path', `url(#${id})`);
}

/// Draws the axes. Returns a group clipped to the frame.
export function openMap(svg: Group, id: string, { side, toX, toY }: MapFrame): Group {
  axes(svg, toX, toY, side, { xLabel: 'x [m]', yLabel: 'y [m]' });
  return clippedGroup(svg, id, side);
}

/// Places an image of `size` metres with its south-western corner at `low`.
export function layPicture(group: Group, { toX, toY, scale }: MapFrame, href: string, name: string, low: Point, size: Point): Group {
  const image = group.append('image').attr('class', name).attr('href', href).attr('preserveAspectRatio', 'none');
  image.attr('x', toX(low[0])).attr('y', toY(low[1] + size[1]));
  return image.attr('width', size[0] * scale).attr('height', size[1] * scale);
}

/// Lays a picture of the grid points of a relief.
export function layRelief(group: Group, frame: MapFrame, { x0, y0, cell_m, columns, rows }: Relief, picture: string) {
  layPicture(group, frame, picture, 'relief', [x0 - cell_m / 2, y0 - cell_m / 2], [columns * cell_m, rows * cell_m]);
}

function systemText(run: Run): string {
  if (run.terrain.crs_wkt) return crsText(run.terrain.crs_wkt);
  return tableOf(run, 'terrain').crs === 'local' ? 'Local coordinates' : 'Coordinate system unknown';
}

/// Scale and coordinate system of a map of a run.
export interface MapNotes {
  run: Run;
  /// Further notes beside the scale.
  more?: readonly string[];
  /// The first line below the axis, and where everything else ends.
  y: number;
  lowest: number;
}

/// Writes them: at the right below a wide map, otherwise below everything else. Returns the y of their end.
export function noteMap(svg: Group, { width, isBeside }: MapRoom, frame: MapFrame, { run, more = [], y, lowest }: MapNotes): number {
  const lines = [[scaleText(frame.denominator), ...more].join(', '), systemText(run)];
  const top = isBeside ? y : lowest + 22;
  lines.forEach((line, k) => {
    const text = svg.append('text').attr('class', 'map-note').attr('text-anchor', isBeside ? 'end' : 'start').text(line);
    text.attr('x', isBeside ? width - 12 : frame.side.left).attr('y', top + 17 * k);
  });
  return Math.max(lowest, top + 17) + 8;
}

/// The boxes of scale bar and north arrow.
export const fixedBoxes = ({ side, scale }: MapFrame) => cornerBoxes(side, scale);

/// Scale bar, north arrow, barriers and their names; `taken`: the boxes that names must not cover.
export function finishMap(group: Group, frame: MapFrame, run: Run, barriers: readonly Settings[], taken: Box[] = fixedBoxes(frame)) {
  drawBarriersOnPlan(group, barriers, frame, taken);
  drawScaleBar(group, frame.side, frame.scale);
  drawNorthArrow(group, frame.side, Boolean(run.terrain.crs_wkt));
}
