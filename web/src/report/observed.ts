// Observed stops over the simulated end points, their distributions, and the distance between both beside that by chance.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';
import { extentOf, legend, sign, tip } from '../figures/report';
import { drawing, element, figure } from './figure';
import { count, displayOf, isNumber, number, resultIn, unitIn } from './format';
import { finishMap, groundOf, hillshade, layRelief, mapFrame, noteMap, openMap } from './mapframe';
import { mapRoom, mapWidth } from './mapRoom';
import { contoursWithin } from './plan';
import { barriersOf, endText, placeText, runs, single } from './run';
import { table } from './tables';

// A diamond, so that it differs from a round end point without its colour.
const stopShape = 'M0,-5L5,0L0,5L-5,0Z';
const stopSign = (g) => g.append('path').attr('class', 'stop').attr('d', stopShape).attr('transform', 'translate(11,0)');
const stopText = (run) => (stop) => [`Observed stop${stop.name ? ' ' + stop.name : ''}`,
  placeText(run, stop),
  ...(isNumber(stop.mass_kg) ? [`mass ${resultIn('kg', stop.mass_kg)} ${unitIn('kg')}`] : [])].join('\n');

function drawStops(group, run, toX, toY) {
  tip(group.append('g').selectAll('path').data(run.stops).enter().append('path').attr('class', 'stop').attr('d', stopShape)
    .attr('transform', (stop) => `translate(${toX(stop.x).toFixed(2)},${toY(stop.y).toFixed(2)})`), stopText(run));
}

function observedPlan(parent, run) {
  const xs = [...run.endpoints, ...run.stops].map((p) => p.x), ys = [...run.endpoints, ...run.stops].map((p) => p.y);
  const view = {x: extentOf(xs, 0.1), y: extentOf(ys, 0.1)};
  const width = mapWidth(view), relief = run.terrain.relief;
  const picture = relief ? hillshade(relief) : null;
  figure(parent, {
    title: 'Observed stops and simulated end points' + (single ? '' : ` · ${run.label}`),
    label: 'Plan with observed stops and simulated end points',
    caption: `${count(run.stops.length, 'observed stop')}, end points of ${count(run.endpoints.length, 'simulated rock')}.`,
    width,
    rows: () => [['of', 'x_m', 'y_m'], ...run.endpoints.map((e) => ['simulated', e.x, e.y]), ...run.stops.map((s) => ['observed', s.x, s.y])],
    draw(svg) {
      const frame = mapFrame(mapRoom(width), view, groundOf([run], view));
      const {side, toX, toY, shown} = frame;
      const inside = openMap(svg, `observed-frame-${run.index}`, frame);
      if (relief) {
        layRelief(inside, frame, relief, picture);
        const line = d3.line().x((p) => toX(p[0])).y((p) => toY(p[1]));
        for (const {lines} of contoursWithin(relief, shown).lines) inside.append('path').attr('class', 'contour').attr('d', lines.map(line).join(''));
      }
      tip(inside.append('g').style('--run', run.colour).selectAll('circle').data(run.endpoints).enter().append('circle').attr('class', 'end')
        .attr('r', run.endpoints.length > 600 ? 1.8 : 2.8).attr('cx', (e) => toX(e.x)).attr('cy', (e) => toY(e.y)), endText(run));
      drawStops(inside, run, toX, toY);
      finishMap(inside, frame, run, barriersOf(run));
      const y = side.bottom + 58;
      const signs = [{text: 'observed stop', draw: stopSign}, {text: 'simulated end point', draw: sign.circle('end', run.colour)}];
      return noteMap(svg, mapRoom(width), frame, run, [], y, legend(svg, signs, side.left, y, width === drawing.wide ? 0.6 * width : width) + 6);
    },
  });
  return width;
}

const observedTitles = {
  position: () => 'Position on plan', x: () => 'x of the end point', runout: (observed) => `Runout ${observed.runout}`, lateral: () => 'Distance beside the line',
};

function observedCurves(parent, run) {
  for (const quantity of run.observed.quantities.filter((q) => q.simulated)) {
    const title = observedTitles[quantity.key](run.observed);
    const curves = [
      {name: 'simulated', colour: run.colour, points: quantity.simulated.cumulative},
      {name: 'observed', colour: 'var(--observed)', points: quantity.observed.cumulative},
    ];
    figure(parent, {
      title: title + (single ? '' : ` · ${run.label}`), label: `${title}: cumulative distribution of observed and simulated rocks`, caption: '', tall: 278,
      fill: (element, room) => figures.cumulative(element, room, {title, ...displayOf('m'), thing: 'rock', of: curves}),
      rows: () => figures.cumulativeRows(curves, `${quantity.key}_m`),
    });
  }
}

const pText = (p) => p < 0.01 ? '< 1 %' : `${number(100 * p, 2)} %`;

function observedTable(parent, run) {
  const {quantities, rocks, draws} = run.observed;
  const row = (name, distance, unit) => [{text: name, unit: unitIn(unit)}, ...['value', 'median', 'p95'].map((key) => resultIn(unit, distance[key])), pText(distance.p_value)];
  table(parent, {
    caption: 'Distance between observed and simulated' + (single ? '' : ` · ${run.label}`),
    head: [['', 'Observed', 'By chance, median', 'By chance, 95 %', 'Chance is as far']],
    rows: quantities.flatMap((q) => {
      const title = observedTitles[q.key](run.observed);
      return [row(`${title}, energy distance`, q.energy_distance, 'm'),
        ...(q.kolmogorov_smirnov ? [row(`${title}, Kolmogorov–Smirnov`, q.kolmogorov_smirnov, '')] : [])];
    }),
    numeric: (column) => column > 0,
  });
  const lines = quantities.filter((q) => q.simulated);
  if (lines.length) {
    table(parent, {
      caption: 'Observed and simulated values' + (single ? '' : ` · ${run.label}`),
      head: [['', '', 'Mean', '5 %', 'Median', '95 %']],
      rows: lines.flatMap((q) => ['observed', 'simulated'].map((of) =>
        [{text: observedTitles[q.key](run.observed), unit: unitIn('m')}, of, ...['mean', 'p05', 'median', 'p95'].map((key) => resultIn('m', q[of][key]))])),
      numeric: (column) => column > 1,
    });
  }
  const left = (run.summary.end_reasons || {})['left the model'];
  element(parent, 'p', `By chance: the same distance of ${count(run.stops.length, 'rock')} drawn from the ${count(rocks, 'simulated rock')} of the page, ${number(draws)} times. ` +
    'A distance beyond its 95 % is hardly due to chance alone: places, materials or releases differ from those of the observed rocks. A distance within it does not prove the model; few stops find only large differences. ' +
    (left ? `${count(left, 'rock')} left the model and count where they left it. ` : '') +
    'Energy distance: Székely and Rizzo (2013), twice the mean distance between an observed and a simulated rock, less the mean distances within each.', {class: 'quiet'});
}

export function observedFigures(parent) {
  for (const run of runs.filter((each) => each.observed)) {
    if (!run.observed.rocks) {
      element(parent, 'p', 'There are no end points to compare with: the run wrote none (output.endpoints).', {class: 'quiet'});
      continue;
    }
    const box = element(parent, 'div', null, {class: 'columns'});
    const planWidth = run.isSection ? null : observedPlan(box, run);
    observedCurves(planWidth === drawing.half ? element(box, 'div') : box, run);  // beside a tall plan, or below a wide one
    observedTable(parent, run);
  }
}
