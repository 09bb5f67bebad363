// The slope in section with trajectories.

import * as d3 from '../figures/d3';
import { axes, extentOf, legend, sign, tip } from '../figures/report';
import { drawing, element, figure } from './figure';
import { axisIn, count, energyText, givenLength, isNumber, lengthText, measured, number, unitIn } from './format';
import { boxOfText, drawScaleBar, scaleText } from './mapframe';
import { roundScale, unitsPerMetre } from './mapRoom';
import { barrierLine, barriersOf, endText, materialsOf, placeText, runs, single, startOfSentence } from './run';
import { endColour, endSigns } from './shapes';

// ---- the selected rock of each run, shown in red

export const choice = {rocks: runs.map((run) => run.rocks[0] || null), listeners: []};

export function choose(rock) {
  choice.rocks[rock.run] = rock;
  choice.listeners.forEach((listener) => listener());
}

const sectionLeft = 68;  // of the frame

// The round scale at which a section of these lengths fits.
export const sectionScaleIn = (width, tallest, du, dz) =>
  roundScale(unitsPerMetre(1) * Math.max(du / (width - sectionLeft - 14), dz / tallest));

// A frame with the same round scale on both axes, as large as the width and `tallest` allow. It is no wider than its
// content, so that the legend fits next to it.
function equalFrame(width, du, dz, tallest) {
  const left = sectionLeft, denominator = sectionScaleIn(width, tallest, du, dz);
  const scale = unitsPerMetre(denominator);
  const room = Math.max(du * scale, Math.min(420, width - left - 14)), height = Math.max(dz * scale, 110);
  const side = {left, top: 12, right: left + room, bottom: 12 + height};
  const isBeside = width - side.right > 190;
  const drawLegend = (svg, entries) => {
    if (!isBeside) return legend(svg, entries, side.left, side.bottom + 58, side.right) + 12;
    entries.forEach((entry, i) => legend(svg, [entry], side.right + 26, side.top + 12 + 23 * i));
    return Math.max(side.bottom + 46, side.top + 23 * entries.length + 12);
  };
  return {side, room, height, scale, denominator, legend: drawLegend};
}

// ---- the horizontal axis: x if any run is two-dimensional, otherwise the mean direction of travel

export const travel = (() => {
  const starts = [], ends = [];
  for (const rock of runs.flatMap((run) => run.rocks)) {
    starts.push(rock.rows[0]);
    ends.push(rock.rows[rock.rows.length - 1]);
  }
  if (runs.some((run) => run.isSection) || !starts.length) {
    return {along: (x) => x, label: 'x', origin: {x: 0, y: 0}, direction: [1, 0], isX: true};
  }
  const origin = {x: d3.mean(starts, (p) => p.x), y: d3.mean(starts, (p) => p.y)};
  const dx = d3.mean(ends, (p) => p.x) - origin.x, dy = d3.mean(ends, (p) => p.y) - origin.y;
  const length = Math.hypot(dx, dy);
  const direction = length > 0 ? [dx / length, dy / length] : [1, 0];
  const bearing = (Math.atan2(direction[0], direction[1]) * 180 / Math.PI + 360) % 360;
  return {
    along: (x, y) => (x - origin.x) * direction[0] + (y - origin.y) * direction[1],
    label: 'Distance along the mean direction of travel', bearing: `${bearing.toFixed(0).padStart(3, '0')}°`,
    origin, direction, isX: false,
  };
})();

// The SVG path through the rows of paths.csv. A flight is a parabola, that is a quadratic Bézier curve whose control
// point is half the flight time along the tangent at departure; other rows are joined by straight lines.
function pathText(rock, toX, toY, horizontal, horizontalSpeed) {
  let text = '';
  rock.rows.forEach((row, i) => {
    const to = `${toX(horizontal(row)).toFixed(2)},${toY(row.z).toFixed(2)}`;
    if (i === 0) {
      text = 'M' + to;
      return;
    }
    const from = rock.rows[i - 1];
    const half = (row.time - from.time) / 2;
    if (from.state === 'projectile' && half > 0) {
      text += `Q${toX(horizontal(from) + horizontalSpeed(from) * half).toFixed(2)},${toY(from.z + from.vz * half).toFixed(2)} ${to}`;
    } else {
      text += 'L' + to;
    }
  });
  return text;
}

const gravityOf = (run) => (run.project.analysis || {}).gravity_m_s2 || 9.80665;

function heightsOf(rock) {
  const g = gravityOf(runs[rock.run]);
  return rock.rows.flatMap((row) => row.state === 'projectile' && row.vz > 0 ? [row.z, row.z + row.vz ** 2 / (2 * g)] : [row.z]);
}

function rockText(rock) {
  const run = runs[rock.run];
  const last = rock.rows[rock.rows.length - 1];
  const end = run.endpoints.find((e) => e.rock === rock.rock);
  const lines = [`Rock ${rock.rock}` + (single ? '' : ` · ${run.label}`)];
  if (end) lines.push(`${end.end_reason} after ${measured(last.time)} s`);
  lines.push(`end: ${placeText(run, last)}`);
  if (end) lines.push(`runout ${lengthText(end.runout_xy)}, maximum total kinetic energy ${energyText(end.max_ke)}`);
  return lines.join('\n');
}

// Draws trajectories and end points into a group; `textOf` returns a rock's SVG path.
export function drawRocks(group, textOf, toX, toY, endX, endY) {
  for (const run of runs) {
    const opacity = Math.min(0.85, Math.max(0.16, 5 / Math.sqrt(run.rocks.length || 1)));
    tip(group.append('g').style('--run', run.colour).selectAll('path').data(run.rocks).enter().append('path')
      .attr('class', 'path').attr('stroke-opacity', opacity).attr('d', textOf)
      .each(function (rock) { this.addEventListener('click', () => choose(rock)); }), rockText);
  }
  for (const rock of choice.rocks.filter((r) => r)) {
    tip(group.append('path').datum(rock).attr('class', rock.run ? 'path chosen second' : 'path chosen').attr('d', textOf(rock)), rockText);
  }
  for (const run of runs) {
    tip(group.append('g').style('--run', run.colour).selectAll('circle').data(run.endpoints).enter().append('circle')
      .attr('class', 'end').attr('r', run.endpoints.length > 600 ? 1.8 : 2.8).style('--run', (e) => endColour(run, e))
      .attr('cx', (e) => toX(endX(e))).attr('cy', (e) => toY(endY(e))), endText(run));
  }
  drawReleases(group, runs, toX, toY, endX, endY);
}

// Draws one ring for all releases at the same pixel.
export function drawReleases(group, shown, toX, toY, endX, endY) {
  const starts = shown.flatMap((run) => run.rocks.map((rock) => rock.rows[0]));
  const seen = new Set();
  for (const start of starts) {
    const at = [toX(endX(start)).toFixed(0), toY(endY(start)).toFixed(0)].join();
    if (seen.has(at)) continue;
    seen.add(at);
    group.append('circle').attr('class', 'release').attr('r', 3.2).attr('cx', toX(endX(start))).attr('cy', toY(endY(start)));
  }
}

// The table saved by the CSV buttons of section and plan: the rows of the trajectories shown.
export function shownRows() {
  const names = {rock: 'rock', state: 'state', time: 'time_s', x: 'x_m', y: 'y_m', z: 'z_m', vx: 'vx_m_s', vy: 'vy_m_s', vz: 'vz_m_s'};
  const keys = Object.keys(names);
  return [['run', ...Object.values(names)], ...runs.flatMap((run) => run.rocks.flatMap((rock) =>
    rock.rows.map((row) => [run.label, ...keys.map((key) => key === 'rock' ? rock.rock : row[key])])))];
}

export function shownText() {
  const parts = runs.map((run) => {
    const mark = single ? '' : `${run.label}: `;
    const planned = run.summary.rocks && run.summary.rocks.done;
    const all = isNumber(planned) ? planned : run.rocksWithPaths;
    const ends = run.endpointTotal > run.endpoints.length ? `, end points of ${number(run.endpoints.length)}` : '';
    return `${mark}showing ${number(run.rocks.length)} of ${count(all, 'rock')}${ends}`;
  });
  return startOfSentence(parts.join('; ')) + '. ';
}

// ---- the ground in section

const materialColour = (run, name) => {
  const index = materialsOf(run).findIndex((m) => m.name === name);
  return index < 0 ? null : `var(--m${index % 6})`;
};

function interpolated(points, u) {
  let best = null;
  for (let i = 0; i + 1 < points.length; ++i) {
    const [a, b] = [points[i], points[i + 1]];
    if (u < Math.min(a[0], b[0]) || u > Math.max(a[0], b[0])) continue;
    const z = a[0] === b[0] ? Math.max(a[1], b[1]) : a[1] + (b[1] - a[1]) * (u - a[0]) / (b[0] - a[0]);
    best = best === null ? z : Math.max(best, z);
  }
  return best;
}

function reliefHeight(relief, x, y) {
  const i = (x - relief.x0) / relief.cell_m, j = (y - relief.y0) / relief.cell_m;
  const i0 = Math.min(Math.floor(i), relief.columns - 2), j0 = Math.min(Math.floor(j), relief.rows - 2);
  if (i < -1e-6 || j < -1e-6 || i > relief.columns - 1 + 1e-6 || j > relief.rows - 1 + 1e-6 || i0 < 0 || j0 < 0) return null;
  const at = (a, b) => relief.z_m[b * relief.columns + a];
  const corners = [at(i0, j0), at(i0 + 1, j0), at(i0, j0 + 1), at(i0 + 1, j0 + 1)];
  if (corners.some((z) => !isNumber(z))) return null;
  const s = i - i0, t = j - j0;
  return (corners[0] * (1 - s) + corners[1] * s) * (1 - t) + (corners[2] * (1 - s) + corners[3] * s) * t;
}

// The terrain along the section line through the mean release point, within the relief.
function reliefProfile(relief, low, high) {
  const points = [];
  const steps = 600;
  for (let k = 0; k <= steps; ++k) {
    const u = low + (high - low) * k / steps;
    const x = travel.isX ? u : travel.origin.x + u * travel.direction[0];
    const y = travel.isX ? relief.y0 + relief.cell_m * (relief.rows - 1) / 2 : travel.origin.y + u * travel.direction[1];
    const z = reliefHeight(relief, x, y);
    if (z !== null) points.push([u, z]);
  }
  return points;
}

// What the section shows; null if the runs have neither a section nor trajectories.
export const slope = (() => {
  const grounds = [];
  const us = [], zs = [];
  for (const run of runs) {
    for (const rock of run.rocks) {
      rock.rows.forEach((row) => us.push(travel.along(row.x, row.y)));
      heightsOf(rock).forEach((z) => zs.push(z));
    }
    run.endpoints.forEach((e) => { us.push(travel.along(e.x, e.y)); zs.push(e.z); });
    if (run.isSection && Array.isArray(run.terrain.section)) grounds.push({run, points: run.terrain.section, section: true});
  }
  const reach = extentOf(us, 0.12);
  for (const run of runs) {
    if (!run.isSection && run.terrain.relief && !grounds.some((g) => g.section)) grounds.push({run, points: reliefProfile(run.terrain.relief, ...reach), section: false});
  }
  for (const ground of grounds) ground.points.forEach(([u, z]) => { us.push(u); zs.push(z); });
  if (!us.length) return null;
  const walls = runs.flatMap((run) => barriersOf(run).map((barrier) => {
    const line = barrierLine(barrier);
    if (!line.length || !isNumber(barrier.height_m)) return null;
    const middle = line.length === 1 ? line[0] : [d3.mean(line, (p) => p[0]), d3.mean(line, (p) => p[1])];
    if (line.length > 1) {  // drawn only if the section crosses it rather than runs along it
      const last = line[line.length - 1];
      const across = Math.hypot(last[0] - line[0][0], last[1] - line[0][1]);
      const along = Math.abs((last[0] - line[0][0]) * travel.direction[0] + (last[1] - line[0][1]) * travel.direction[1]);
      if (along > 0.7 * across) return null;
    }
    const u = travel.along(...middle);
    const from = grounds.find((g) => g.run === run) || grounds[0];
    const foot = from ? interpolated(from.points, u) : null;
    if (foot === null) return null;
    const lean = (barrier.inclination_deg || 0) * Math.PI / 180;
    return {barrier, u, foot, top: [u - barrier.height_m * Math.sin(lean), foot + barrier.height_m * Math.cos(lean)]};
  })).filter((wall, i, all) => wall && all.findIndex((w) => w && w.barrier.name === wall.barrier.name && w.u === wall.u) === i);
  walls.forEach((wall) => zs.push(wall.top[1]));

  const [u0, u1] = extentOf(us, 0.02), [z0, z1] = extentOf(zs, 0.06);
  const agree = grounds.length === 2 && JSON.stringify(grounds[0].points) === JSON.stringify(grounds[1].points);
  return {grounds, walls, agree, u: [u0, u1], z: [z0, z1]};
})();

// Draws the section into a frame of at most this size. Returns the y of its end.
export function drawSection(svg, width, tallest, id) {
  const {grounds, walls, agree, u: [u0, u1], z: [z0, z1]} = slope;
  const frame = equalFrame(width, u1 - u0, z1 - z0, tallest);
  const {side, room, height, scale} = frame;
  const middleU = (u0 + u1) / 2, middleZ = (z0 + z1) / 2;
  const toX = d3.scaleLinear().domain([middleU - room / scale / 2, middleU + room / scale / 2]).range([side.left, side.right]);
  const toY = d3.scaleLinear().domain([middleZ - height / scale / 2, middleZ + height / scale / 2]).range([side.bottom, side.top]);
  axes(svg, axisIn('m', toX), axisIn('m', toY), side, {xLabel: `${travel.label} [${unitIn('m')}]`, yLabel: `z [${unitIn('m')}]`});
  svg.append('clipPath').attr('id', id).append('rect').attr('x', side.left).attr('y', side.top).attr('width', room).attr('height', height);
  const inside = svg.append('g').attr('clip-path', `url(#${id})`);
  const line = d3.line().x((p) => toX(p[0])).y((p) => toY(p[1]));
  const used = new Set();
  grounds.forEach((ground, k) => {
    if (!ground.points.length || (agree && k > 0)) return;
    const first = ground.points[0], last = ground.points[ground.points.length - 1];
    if (k === 0) inside.append('path').attr('class', 'ground').attr('d', `${line(ground.points)}L${toX(last[0])},${side.bottom}L${toX(first[0])},${side.bottom}Z`);
    inside.append('path').attr('class', 'ground-line').attr('d', line(ground.points))
      .style('stroke', grounds.length > 1 && !agree ? ground.run.colour : null);
    const land = ground.run.project.ground || {};
    if (!ground.section || (grounds.length > 1 && !agree) || !materialsOf(ground.run).length) return;
    for (let i = 0; i + 1 < ground.points.length; ++i) {
      const name = (Array.isArray(land.segments) && land.segments[i]) || land.default;
      const colour = materialColour(ground.run, name);
      if (!colour) continue;
      used.add(name);
      tip(inside.append('path').attr('class', 'ground-line').attr('d', line([ground.points[i], ground.points[i + 1]]))
        .style('stroke', colour).style('stroke-width', 4), () => `Segment ${i + 1}: ${name}`);
    }
  });
  const horizontal = (row) => travel.along(row.x, row.y);
  const speed = (row) => row.vx * travel.direction[0] + row.vy * travel.direction[1];
  drawRocks(inside, (rock) => pathText(rock, toX, toY, horizontal, speed), toX, toY, horizontal, (e) => e.z);
  for (const wall of walls) {
    inside.append('line').attr('class', 'barrier').attr('x1', toX(wall.u)).attr('y1', toY(wall.foot)).attr('x2', toX(wall.top[0])).attr('y2', toY(wall.top[1]));
    const name = `${wall.barrier.name}, ${givenLength(wall.barrier.height_m)}`, x = toX(wall.top[0]), y = toY(wall.top[1]) + 2;
    const isCut = boxOfText(name, 'start', x + 7, y)[2] > side.right;
    inside.append('text').attr('class', 'barrier-name halo').attr('x', isCut ? x - 7 : x + 7).attr('y', y).attr('text-anchor', isCut ? 'end' : 'start').text(name);
  }
  drawScaleBar(inside, side, scale);
  const end = frame.legend(svg, [
    ...runs.map((run) => ({text: single ? 'trajectory' : run.label, draw: sign.line('path', run.colour)})),
    {text: 'selected rock', draw: sign.line('path chosen', 'var(--chosen)')},
    {text: 'release', draw: sign.circle('release', '')},
    ...(single ? endSigns(runs[0]) : []),
    ...[...used].map((name) => ({text: name, draw: (g) => g.append('line').attr('class', 'ground-line').attr('x2', 22).style('stroke', materialColour(runs[0], name)).style('stroke-width', 4)})),
  ]);
  svg.append('text').attr('class', 'map-note').attr('x', side.left).attr('y', end + 8).text(`${scaleText(frame.denominator)}, both axes`);
  return end + 16;
}

function sectionCaption() {
  const {grounds} = slope;
  const notes = [shownText(), 'Both axes have the same scale; flights are true parabolas. Click a trajectory to select its rock.'];
  if (grounds.some((g) => !g.section)) {
    notes.push(travel.isX ? 'The ground is drawn along the middle of the terrain.' : 'The ground is drawn along a line through the mean release point; rocks off that line may appear above or below the ground.');
  }
  if (!travel.isX) notes.push(`The mean direction of travel is ${travel.bearing} clockwise from the y axis.`);
  if (!grounds.length) notes.push('The summary has no ground to draw.');
  return notes.join(' ');
}

export function sectionFigure(parent, width = drawing.wide) {
  if (!slope) return element(parent, 'p', 'The run has neither a section nor trajectories to draw.', {class: 'quiet'});
  const made = figure(parent, {
    title: 'Section with trajectories',
    label: 'Section of the slope with trajectories; both axes have the same scale',
    caption: sectionCaption(),
    width,
    rows: shownRows,
    draw: (svg) => drawSection(svg, width, 325, 'section-frame'),
  });
  choice.listeners.push(made.redraw);
}
