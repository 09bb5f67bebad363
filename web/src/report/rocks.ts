// Trajectories, end points and releases, as section and plan draw them.

import { sign, type Group, type LegendEntry } from '../figures/plot';
import { tip } from '../figures/tip';
import { choice, choose } from './choice';
import type { EndPoint, Rock } from './data';
import { count, energyText, isNumber, lengthText, measured, number } from './format';
import { endText, firstRun, placeText, runs, single, startOfSentence, type Run } from './run';
import { endColour, endSigns } from './shapes';
import { releasesOf } from './travel';

interface Place {
  x: number;
  y: number;
  z: number;
}
/// Where a drawing has a place.
export type PlaceOnDrawing = (place: Place) => [x: number, y: number];

function rockText({ rock, run: index, rows }: Rock): string {
  const run = runs[index];
  const last = rows.at(-1);
  if (!run || !last) return '';
  const end = run.endpoints.find((each) => each.rock === rock);
  return [
    `Rock ${rock}${single ? '' : ` · ${run.label}`}`,
    ...(end ? [`${end.end_reason} after ${measured(last.time)} s`] : []),
    `end: ${placeText(run, last)}`,
    ...(end ? [`runout ${lengthText(end.runout_xy)}, maximum total kinetic energy ${energyText(end.max_ke)}`] : []),
  ].join('\n');
}

/// End points with their tooltips, in the colour of the run or in their own.
export function drawEnds(group: Group, run: Run, at: PlaceOnDrawing, colourOf?: (end: EndPoint) => string) {
  const ends = group.append('g').style('--run', run.colour).selectAll('circle').data(run.endpoints).enter().append('circle');
  ends
    .attr('class', 'end')
    .attr('r', run.endpoints.length > 600 ? 1.8 : 2.8)
    .attr('cx', (end) => at(end)[0])
    .attr('cy', (end) => at(end)[1]);
  if (colourOf) ends.style('--run', colourOf);
  tip(ends, endText(run));
}

/// Draws one ring for all releases at the same pixel.
export function drawReleases(group: Group, shown: readonly Run[], at: PlaceOnDrawing) {
  const seen = new Set<string>();
  for (const start of shown.flatMap(releasesOf)) {
    const [x, y] = at(start);
    const pixel = `${x.toFixed(0)},${y.toFixed(0)}`;
    if (seen.has(pixel)) continue;
    seen.add(pixel);
    group.append('circle').attr('class', 'release').attr('r', 3.2).attr('cx', x).attr('cy', y);
  }
}

/// Draws trajectories, end points and releases of all runs; `pathOf` returns the path of a rock.
export function drawRocks(group: Group, pathOf: (rock: Rock) => string, at: PlaceOnDrawing) {
  for (const { rocks, colour } of runs) {
    const opacity = Math.min(0.85, Math.max(0.16, 5 / Math.sqrt(rocks.length || 1)));
    const paths = group.append('g').style('--run', colour).selectAll('path').data(rocks).enter().append('path');
    paths.attr('class', 'path').attr('stroke-opacity', opacity).attr('d', pathOf);
    tip(paths.on('click', (_, rock) => choose(rock)), rockText);
  }
  for (const rock of choice.rocks) {
    if (!rock) continue;
    const path = group.append('path').attr('class', rock.run > 0 ? 'path chosen second' : 'path chosen');
    tip(path.attr('d', pathOf(rock)), () => rockText(rock));
  }
  for (const run of runs) drawEnds(group, run, at, (end) => endColour(run, end));
  drawReleases(group, runs, at);
}

/// The legend of `drawRocks`.
export const rockSigns = (): LegendEntry[] => [
  ...runs.map(({ label, colour }) => ({ text: single ? 'trajectory' : label, draw: sign.line('path', colour) })),
  { text: 'selected rock', draw: sign.line('path chosen', 'var(--chosen)') },
  { text: 'release', draw: sign.circle('release') },
  ...(single ? endSigns(firstRun) : []),
];

/// The table saved by the CSV buttons of section and plan: the rows of the trajectories shown.
export function shownRows() {
  const columns = ['run', 'rock', 'state', 'time_s', 'x_m', 'y_m', 'z_m', 'vx_m_s', 'vy_m_s', 'vz_m_s'];
  const rows = runs.flatMap(({ label, rocks }) =>
    rocks.flatMap(({ rock, rows: steps }) =>
      steps.map(({ state, time, x, y, z, vx, vy, vz }) => [label, rock, state, time, x, y, z, vx, vy, vz]),
    ),
  );
  return [columns, ...rows];
}

export function shownText(): string {
  const parts = runs.map(({ label, rocks, rocksWithPaths, summary, endpoints, endpointTotal }) => {
    const done = summary.rocks?.done;
    const all = isNumber(done) ? done : rocksWithPaths;
    const ends = endpointTotal > endpoints.length ? `, end points of ${number(endpoints.length)}` : '';
    return `${single ? '' : `${label}: `}showing ${number(rocks.length)} of ${count(all, 'rock')}${ends}`;
  });
  return `${startOfSentence(parts.join('; '))}. `;
}
