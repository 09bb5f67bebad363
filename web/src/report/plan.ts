// The plan of a terrain with contours, trajectories and end points.

import * as d3 from '../figures/d3';
import { extentOf, legend, sign, tip } from '../figures/report';
import { drawing, element, figure } from './figure';
import { displayOf, givenLength, isNumber, unitSystem } from './format';
import { boxOfText, finishMap, fixedBoxes, groundOf, hillshade, isFree, layRelief, mapFrame, noteMap, openMap } from './mapframe';
import { mapRoom, mapWidth, metresPerUnit } from './mapRoom';
import { barrierLine, barriersOf, runs, single } from './run';
import { endSigns } from './shapes';
import { choice, drawRocks, shownRows, shownText } from './slope';

// Contours as lists of points [x, y]. They stop at holes and at the edge of the relief.
function contourLines(relief, levels) {
  const {columns, rows, cell_m, x0, y0, z_m} = relief;
  const low = levels[0] - (levels[1] - levels[0] || 1) * 1000;
  const values = z_m.map((z) => isNumber(z) ? z : low);
  const known = (i, j) => i >= 0 && j >= 0 && i < columns && j < rows && isNumber(z_m[j * columns + i]);
  const inside = ([a, b]) => [Math.floor(a), Math.ceil(a)].every((i) => [Math.floor(b), Math.ceil(b)].every((j) => known(i, j)));
  return d3.contours().size([columns, rows]).thresholds(levels)(values).map((shape) => {
    const lines = [];
    for (const ring of shape.coordinates.flat()) {
      let line = [];
      for (const [a, b] of ring) {
        const point = [a - 0.5, b - 0.5];  // d3-contour has grid points at half-integers
        if (inside(point)) {
          line.push([x0 + point[0] * cell_m, y0 + point[1] * cell_m]);
        } else if (line.length) {
          lines.push(line);
          line = [];
        }
      }
      if (line.length) lines.push(line);
    }
    return {level: shape.value, lines: lines.filter((line) => line.length > 1)};
  });
}

// The relief's heights within a rectangle, or all of them if it contains no grid point.
function heightsWithin(relief, {x: [x0, x1], y: [y0, y1]}) {
  const inside = relief.z_m.filter((z, k) => {
    const x = relief.x0 + (k % relief.columns) * relief.cell_m, y = relief.y0 + Math.floor(k / relief.columns) * relief.cell_m;
    return isNumber(z) && x >= x0 && x <= x1 && y >= y0 && y <= y1;
  });
  return inside.length ? inside : relief.z_m.filter(isNumber);
}

export function contoursWithin(relief, view) {
  const [low, high] = d3.extent(heightsWithin(relief, view));
  const {per} = displayOf('m');
  const levels = high > low ? d3.ticks(low / per, high / per, 25).map((level) => level * per) : [];
  const interval = levels.length > 1 ? levels[1] - levels[0] : 0;
  return {interval, lines: interval ? contourLines(relief, levels) : []};
}

// The two extents of the plan: rocks with barriers, and the whole terrain.
function planViews(spatial, relief) {
  const xs = [], ys = [];
  for (const run of spatial) {
    run.rocks.forEach((rock) => rock.rows.forEach((row) => { xs.push(row.x); ys.push(row.y); }));
    run.endpoints.forEach((e) => { xs.push(e.x); ys.push(e.y); });
    barriersOf(run).forEach((barrier) => barrierLine(barrier).forEach(([x, y]) => { xs.push(x); ys.push(y); }));
  }
  const view = (margin) => ({x: extentOf(xs, margin), y: extentOf(ys, margin)});
  const rocks = xs.length ? view(0.15) : null;
  for (const run of spatial) {
    if (Array.isArray(run.terrain.bounds)) run.terrain.bounds.forEach(([x, y]) => { xs.push(x); ys.push(y); });
  }
  if (relief) {
    xs.push(relief.x0, relief.x0 + (relief.columns - 1) * relief.cell_m);
    ys.push(relief.y0, relief.y0 + (relief.rows - 1) * relief.cell_m);
  }
  return xs.length ? {rocks, terrain: view(0.01)} : null;
}

// Whether the rocks cover so little of the terrain that the plan opens zoomed in on them.
function coversLittle({rocks, terrain}) {
  const room = mapRoom(drawing.wide);
  return rocks !== null && metresPerUnit(room, terrain) > 1.6 * metresPerUnit(room, rocks);
}

// What a plan shows; null if there is no run in 3D to draw.
export const plan = (() => {
  const spatial = runs.filter((run) => !run.isSection);
  const reliefRun = spatial.find((run) => run.terrain.relief);
  const relief = reliefRun && reliefRun.terrain.relief;
  const views = spatial.length ? planViews(spatial, relief) : null;
  return views && {spatial, relief, views, canZoom: coversLittle(views), picture: relief ? hillshade(relief) : null, contours: new Map()};
})();

// Contours within the extent that a frame shows; kept, because they take a while.
function contoursOf(shown) {
  const key = JSON.stringify([shown, unitSystem]);
  if (!plan.contours.has(key)) plan.contours.set(key, plan.relief ? contoursWithin(plan.relief, shown) : {interval: 0, lines: []});
  return plan.contours.get(key);
}

// The names keep clear of the boxes in `taken`, to which theirs are added.
function drawContours(inside, {interval, lines: contourSets}, {toX, toY, shown: {x: [x0, x1], y: [y0, y1]}}, taken) {
  const line = d3.line().x((p) => toX(p[0])).y((p) => toY(p[1]));
  const named = [];  // positions of contour labels, kept apart from each other
  const isShown = ([x, y]) => x > x0 && x < x1 && y > y0 && y < y1;
  for (const {level, lines} of contourSets) {
    const main = Math.round(level / interval) % 5 === 0;
    tip(inside.append('path').attr('class', main ? 'contour main' : 'contour').attr('d', lines.map(line).join('')), () => `z = ${givenLength(level)}`);
    const longest = lines.map((each) => each.filter(isShown)).reduce((a, b) => b.length > a.length ? b : a, []);
    if (!main || longest.length < 8) continue;
    const place = longest[Math.floor(longest.length * 0.12)];
    const text = givenLength(level), at = [toX(place[0]), toY(place[1])];
    const box = boxOfText(text, 'middle', at[0], at[1] + 4);
    if (!isFree(box, taken) || named.some((other) => Math.hypot(other[0] - at[0], other[1] - at[1]) < 46)) continue;
    named.push(at);
    taken.push(box);
    inside.append('text').attr('class', 'contour-name halo').attr('x', at[0]).attr('y', at[1] + 4).attr('text-anchor', 'middle').text(text);
  }
}

const planFrame = (room, extent) => mapFrame(room, plan.views[extent], groundOf(plan.spatial, plan.views[extent]));

// Draws one of the extents of the plan. Returns the y of its end.
export function drawPlan(svg, room, extent, id) {
  const frame = planFrame(room, extent);
  const {side, toX, toY} = frame;
  const contours = contoursOf(frame.shown);
  const inside = openMap(svg, id, frame);
  const taken = fixedBoxes(frame);
  if (plan.relief) {
    layRelief(inside, frame, plan.relief, plan.picture);
    drawContours(inside, contours, frame, taken);
  }
  const flat = (rock) => 'M' + rock.rows.map((row) => `${toX(row.x).toFixed(2)},${toY(row.y).toFixed(2)}`).join('L');
  drawRocks(inside, flat, toX, toY, (e) => e.x, (e) => e.y);
  finishMap(inside, frame, plan.spatial[0], plan.spatial.flatMap(barriersOf), taken);
  const signs = [
    ...runs.map((run) => ({text: single ? 'trajectory' : run.label, draw: sign.line('path', run.colour)})),
    {text: 'selected rock', draw: sign.line('path chosen', 'var(--chosen)')},
    {text: 'release', draw: sign.circle('release', '')},
    ...(single ? endSigns(runs[0]) : []),
    ...(contours.interval ? [{text: 'contour', draw: sign.line('contour main')}] : []),
  ];
  const y = side.bottom + 58;
  return noteMap(svg, room, frame, plan.spatial[0], [], y, legend(svg, signs, side.left, y, room.isBeside ? 0.6 * room.width : room.width));
}

export function planCaption(room, extent) {
  const {interval} = contoursOf(planFrame(room, extent).shown);
  return shownText() + (plan.relief ? `Contours every ${givenLength(interval)}; relief lit from the upper left.` : 'The summary has no relief to draw.') +
    (plan.spatial.length < runs.length ? ` ${runs.find((run) => run.isSection).label} is two-dimensional and drawn at y = 0.` : '');
}

// Returns the figure's width; null if there is no run in 3D to draw.
export function planFigure(parent) {
  if (!plan) return null;
  let shown = plan.canZoom ? 'rocks' : 'terrain';
  const width = mapWidth(plan.views[shown]), room = mapRoom(width);
  const made = figure(parent, {
    title: 'Plan with trajectories',
    label: 'Plan of the terrain with contours, trajectories and end points',
    caption: planCaption(room, shown),
    width,
    rows: shownRows,
    draw: (svg) => drawPlan(svg, room, shown, 'plan-frame'),
  });
  choice.listeners.push(made.redraw);
  if (!plan.canZoom) return width;
  const other = () => shown === 'rocks' ? 'Show the whole terrain' : 'Show the rocks';
  const zoom = element(made.head.insert('span', '.save').attr('class', 'zoom'), 'button', other(), {type: 'button'});
  zoom.on('click', () => {
    shown = shown === 'rocks' ? 'terrain' : 'rocks';
    zoom.text(other());
    made.caption.text(planCaption(room, shown));
    made.redraw();
  });
  return width;
}
