// Common parts of the maps: coordinates, relief, scale bar and north arrow.

import * as d3 from '../figures/d3';
import { axes } from '../figures/report';
import { crsText } from './crs';
import { amountIn, displayOf, givenLength, isNumber, number } from './format';
import { mapScaleIn, roundLength, unitsPerMetre } from './mapRoom';
import { barrierLine, paperName } from './run';


// Extends the interval [a, b] into [low, high] about its centre, up to a length.
function extend([a, b], length, [low, high]) {
  const [first, last] = [Math.min(a, low), Math.max(b, high)];
  if (last - first <= length) return [first, last];
  const from = Math.min(Math.max((a + b - length) / 2, first), last - length);
  return [from, from + length];
}

// The extent of the view and of the terrain of some runs.
export function groundOf(shown, view) {
  const bounds = shown.map((run) => run.terrain.bounds).filter(Array.isArray);
  const along = (axis, name) => d3.extent([...view[name], ...bounds.flatMap((corners) => corners.map((corner) => corner[axis]))]);
  return {x: along(0, 'x'), y: along(1, 'y')};
}

// The frame of a map: the view and as much of the surrounding ground as fits; x and y have the same scale.
export function mapFrame(room, view, ground) {
  const {left, across, tallest, fills} = room;
  const denominator = mapScaleIn(room, view);
  const scale = unitsPerMetre(denominator);
  const x = extend(view.x, across / scale, ground.x);
  const y = extend(view.y, Math.max(view.y[1] - view.y[0], (fills ? tallest : 0.3 * across) / scale), ground.y);
  const side = {left, top: 12, right: left + (x[1] - x[0]) * scale, bottom: 12 + (y[1] - y[0]) * scale};
  const toX = d3.scaleLinear().domain(x).range([side.left, side.right]), toY = d3.scaleLinear().domain(y).range([side.bottom, side.top]);
  return {side, scale, denominator, shown: {x, y}, toX, toY};
}

// Draws the axes. Returns a group clipped to the frame.
export function openMap(svg, id, {side, toX, toY}) {
  axes(svg, toX, toY, side, {xLabel: 'x [m]', yLabel: 'y [m]'});
  svg.append('clipPath').attr('id', id).append('rect').attr('x', side.left).attr('y', side.top).attr('width', side.right - side.left).attr('height', side.bottom - side.top);
  return svg.append('g').attr('clip-path', `url(#${id})`);
}

// Places an image of `size` metres with its south-western corner at `low`.
export const layPicture = (group, {toX, toY, scale}, href, name, low, size) => group.append('image').attr('class', name).attr('href', href)
  .attr('preserveAspectRatio', 'none').attr('x', toX(low[0])).attr('y', toY(low[1] + size[1])).attr('width', size[0] * scale).attr('height', size[1] * scale);

export function layRelief(group, frame, relief, picture) {
  const half = relief.cell_m / 2;
  layPicture(group, frame, picture, 'relief', [relief.x0 - half, relief.y0 - half], [relief.columns * relief.cell_m, relief.rows * relief.cell_m]);
}

const systemText = (run) => {
  if (run.terrain.crs_wkt) return crsText(run.terrain.crs_wkt);
  return (run.project.terrain || {}).crs === 'local' ? 'Local coordinates' : 'Coordinate system unknown';
};

export const scaleText = (denominator) => `Scale 1:${number(denominator)} on ${paperName}`;

// Writes scale and coordinate system: at the right below a wide map, otherwise below everything else (`lowest`). Returns
// the y of their end.
export function noteMap(svg, {width, isBeside}, frame, run, more, y, lowest) {
  const lines = [[scaleText(frame.denominator), ...more].join(', '), systemText(run)];
  const top = isBeside ? y : lowest + 22;
  lines.forEach((text, i) => svg.append('text').attr('class', 'map-note').attr('text-anchor', isBeside ? 'end' : 'start')
    .attr('x', isBeside ? width - 12 : frame.side.left).attr('y', top + 17 * i).text(text));
  return Math.max(lowest, top + 17) + 8;
}

// Shaded relief as an image, lit from the north-west at 45 degrees: one pixel per grid point, enlarged with smoothing
// because printers draw pixels as squares.
export function hillshade(relief) {
  const {columns, rows, cell_m, z_m} = relief;
  const canvas = document.createElement('canvas');
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext('2d');
  const image = context.createImageData(columns, rows);
  const at = (i, j) => z_m[Math.min(Math.max(j, 0), rows - 1) * columns + Math.min(Math.max(i, 0), columns - 1)];
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const z = at(i, j);
      const pixel = 4 * ((rows - 1 - j) * columns + i);
      if (!isNumber(z)) continue;
      const near = (a, b) => isNumber(at(a, b)) ? at(a, b) : z;
      const sx = (near(i + 1, j) - near(i - 1, j)) / (2 * cell_m), sy = (near(i, j + 1) - near(i, j - 1)) / (2 * cell_m);
      const lit = (sx * 0.5 - sy * 0.5 + Math.SQRT1_2) / Math.hypot(sx, sy, 1);
      const grey = Math.round(150 + 100 * Math.min(Math.max(lit, 0), 1));
      image.data.set([grey, grey, Math.max(grey - 6, 0), 255], pixel);
    }
  }
  context.putImageData(image, 0, 0);
  const times = Math.max(1, Math.ceil(800 / Math.max(columns, rows)));
  const large = document.createElement('canvas');
  large.width = columns * times;
  large.height = rows * times;
  const pen = large.getContext('2d');
  pen.imageSmoothingQuality = 'high';
  pen.drawImage(canvas, 0, 0, large.width, large.height);
  return large.toDataURL('image/png');
}

// Boxes [left, top, right, bottom] of marks and names on a map.
export const boxOfText = (text, anchor, x, y) => {
  const width = 7.2 * text.length;
  const left = {start: x, middle: x - width / 2, end: x - width}[anchor];
  return [left, y - 12, left + width, y + 4];
};
const touches = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
export const isFree = (box, taken) => !taken.some((other) => touches(box, other));

// Where the name of a line can stand: beside its last point, its first or a point between, and then above or below.
function namePlaces(text, line, {side, toX, toY}) {
  const points = [line[line.length - 1], line[0], ...[0.85, 0.15, 0.5].map((share) => alongLine(line, share))];
  const beside = (anchor, dx, dy) => points.map((p) => ({anchor, x: toX(p[0]) + dx, y: Math.max(toY(p[1]) + dy, side.top + 14)}));
  const all = [...beside('start', 8, 4), ...beside('end', -8, 4), ...beside('middle', 0, -8), ...beside('middle', 0, 18)];
  return all.map((place) => ({...place, box: boxOfText(text, place.anchor, place.x, place.y)}));
}

// A point of a line on plan, at a share of its length.
function alongLine(line, share) {
  const lengths = line.slice(1).map(([x, y], i) => Math.hypot(x - line[i][0], y - line[i][1]));
  let rest = share * lengths.reduce((sum, each) => sum + each, 0), k = 0;
  while (k < lengths.length - 1 && rest > lengths[k]) rest -= lengths[k++];
  const [a, b] = [line[k], line[k + 1]], t = lengths[k] > 0 ? rest / lengths[k] : 0;
  return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
}

// Draws barriers and collectors; their names keep clear of the boxes in `taken` and of each other.
function drawBarriersOnPlan(group, barriers, frame, taken) {
  const {side: {left, top, right, bottom}, toX, toY} = frame;
  const lines = barriers.map(({name, ...rest}) => ({name, line: barrierLine(rest)})).filter(({line}) => line.length > 1);
  for (const {line} of lines) group.append('path').attr('class', 'barrier').attr('d', 'M' + line.map(([x, y]) => `${toX(x)},${toY(y)}`).join('L'));
  for (const {name, line} of lines) {
    const places = namePlaces(name, line, frame);
    const inside = places.filter(({box}) => box[0] >= left && box[2] <= right && box[1] >= top && box[3] <= bottom);
    const place = inside.find(({box}) => isFree(box, taken)) || inside[0] || places[0];
    taken.push(place.box);
    group.append('text').attr('class', 'barrier-name halo').attr('x', place.x).attr('y', place.y).attr('text-anchor', place.anchor).text(name);
  }
}

const scaleLength = ({left, right}, scale) => roundLength(amountIn('m', (right - left) / scale / 3)) * displayOf('m').per;
const scaleBox = (side, scale) => [side.left + 8, side.bottom - 34, side.left + 20 + scaleLength(side, scale) * scale, side.bottom - 8];

export function drawScaleBar(group, side, scale) {
  const length = scaleLength(side, scale);
  const x = side.left + 12, y = side.bottom - 14;
  const bar = group.append('g').attr('class', 'scale-bar');
  bar.append('path').attr('class', 'halo').attr('d', `M${x},${y - 5}v5h${length * scale}v-5`);
  bar.append('path').attr('d', `M${x},${y - 5}v5h${length * scale}v-5`);
  bar.append('text').attr('class', 'halo').attr('x', x + length * scale / 2).attr('y', y - 5).attr('text-anchor', 'middle').text(givenLength(length));
}

const northBox = ({left, top}) => [left + 8, top + 6, left + 32, top + 48];

// The map's y axis points up; it is north if the terrain has map coordinates.
function drawNorthArrow(group, side, isNorth) {
  const arrow = group.append('g').attr('class', 'north').attr('transform', `translate(${side.left + 20},${side.top + 10})`);
  arrow.append('path').attr('class', 'halo').attr('d', 'M0,0l7,20l-7,-5l-7,5z');
  arrow.append('path').attr('class', 'arrow').attr('d', 'M0,0l7,20l-7,-5l-7,5z');
  arrow.append('text').attr('class', 'halo').attr('y', 33).attr('text-anchor', 'middle').text(isNorth ? 'N' : 'y');
}

// The boxes of scale bar and north arrow.
export const fixedBoxes = ({side, scale}) => [scaleBox(side, scale), northBox(side)];

// Scale bar, north arrow, barriers and their names; `taken`: the boxes that names must not cover.
export function finishMap(group, frame, run, barriers, taken = fixedBoxes(frame)) {
  drawBarriersOnPlan(group, barriers, frame, taken);
  drawScaleBar(group, frame.side, frame.scale);
  drawNorthArrow(group, frame.side, Boolean(run.terrain.crs_wkt));
}
