// Maps of results over the shaded relief, with barriers and releases: bounce height, energy, velocity, reach probability.

import * as d3 from '../figures/d3';
import { extentOf, pointIn, tip } from '../figures/report';
import { drawing, element, figure } from './figure';
import { displayOf, givenIn, isNumber, measured, number, unitIn } from './format';
import { finishMap, groundOf, hillshade, layPicture, layRelief, mapFrame, noteMap, openMap } from './mapframe';
import { mapRoom, mapWidth } from './mapRoom';
import { barrierLine, barriersOf, page, runs, single } from './run';
import { drawReleases } from './slope';

// Units are those of the data. Of a quantity the 95th percentile is shown, or the maximum if the run has no such map.
const quantitiesOfMaps = [
  {name: 'bounce_height', unitInName: 'm', title: 'bounce height', of: 'Bounce height of the lowest point', unit: 'm'},
  {name: 'energy_total', unitInName: 'kJ', title: 'total kinetic energy', of: 'Total kinetic energy', unit: 'kJ'},
  {name: 'velocity', unitInName: 'm_s', title: 'velocity', of: 'Velocity', unit: 'm/s'},
];
const partsOfMaps = [
  {part: 'p95', title: (what) => `95 % ${what}`, of: '95 %'},
  {part: 'max', title: (what) => `Maximum ${what}`, of: 'maximum'},
];

// A map, and the ends of its range between ensembles, by name.
function withEnds(nameOf, kind) {
  const title = (word) => `${kind.title}: ${word} end of the range between ensembles`;
  return [[nameOf(''), kind],
    [nameOf('low_'), {...kind, title: title('low'), quantity: `${kind.title}; 5 % of the ensembles are below`}],
    [nameOf('high_'), {...kind, title: title('high'), quantity: `${kind.title}; 5 % of the ensembles are above`}]];
}

// In the order of the page.
const mapKinds = Object.fromEntries([
  ...quantitiesOfMaps.flatMap(({name, unitInName, title, of, unit}) => partsOfMaps.flatMap((part) =>
    withEnds((end) => `${name}_${part.part}_${end}${unitInName}`, {title: part.title(title), quantity: `${of}, ${part.of}`, unit}))),
  ...withEnds((end) => `reach_share${end && `_${end.slice(0, -1)}`}`, {title: 'Reach probability', quantity: 'Share of all rocks that reach the cell', unit: 'share'}),
  ['reach_share_parameter_part', {title: 'Part of the parameters in the reach probability', quantity: 'Part of its variance between ensembles', unit: 'share'}],
]);

// A map's values in the displayed unit, row by row from the south; null where no rock passed.
function mapValues(map) {
  const {per} = displayOf(mapKinds[map.name].unit);
  const value = (part) => (map.logarithmic ? map.least * (map.greatest / map.least) ** part : map.greatest * part) / per;
  return Array.from(atob(map.levels), (letter) => letter.charCodeAt(0) === 0 ? null : value((letter.charCodeAt(0) - 1) / 254));
}

// The classes of the maps of one kind, the same in every run: lower limits and colours.
function mapScale(maps) {
  const {per} = displayOf(mapKinds[maps[0].name].unit);
  const limits = maps[0].limits.map((limit) => limit / per);
  const colours = page.map_colours.map((rgb) => d3.rgb(...rgb));
  return {limits, colours, colour: (value) => colours[d3.bisectRight(limits, value)]};
}

function mapPicture(map, values, scale) {
  const canvas = document.createElement('canvas');
  canvas.width = map.columns;
  canvas.height = map.rows;
  const context = canvas.getContext('2d');
  const image = context.createImageData(map.columns, map.rows);
  values.forEach((value, k) => {
    if (value === null) return;
    const row = map.rows - 1 - Math.floor(k / map.columns);
    const {r, g, b} = scale.colour(value);
    image.data.set([r, g, b, 215], 4 * (row * map.columns + k % map.columns));
  });
  context.putImageData(image, 0, 0);
  return canvas.toDataURL('image/png');
}

// The extent of all maps, the same for both runs: their cells, barriers and releases.
function mapView() {
  const xs = [], ys = [];
  for (const {origin: [x, y], cell: [dx, dy], columns, rows} of runs.flatMap((run) => run.maps)) {
    xs.push(x, x + columns * dx);
    ys.push(y, y + rows * dy);
  }
  for (const [x, y] of runs.flatMap(barriersOf).flatMap(barrierLine)) { xs.push(x); ys.push(y); }
  for (const {rows: [{x, y}]} of runs.flatMap((run) => run.rocks)) { xs.push(x); ys.push(y); }
  return {x: extentOf(xs, 0.04), y: extentOf(ys, 0.04)};
}

// Draws a bar of the classes with their limits below. Returns the y of its end.
function drawColours(svg, scale, {quantity, unit}, x, y, width) {
  const each = width / scale.colours.length, height = 12;
  svg.append('text').attr('x', x).attr('y', y).text(`${quantity} [${unitIn(unit)}]`);
  scale.colours.forEach((colour, k) => svg.append('rect').attr('class', 'map-class').attr('x', x + k * each).attr('y', y + 8).attr('width', each).attr('height', height).attr('fill', colour));
  scale.limits.forEach((limit, k) => drawTick(svg, x + (k + 1) * each, y + 8 + height, number(limit, 3)));
  return y + 8 + height + 22;
}

function drawTick(svg, x, y, text) {
  svg.append('line').attr('class', 'tick-mark').attr('x1', x).attr('x2', x).attr('y1', y).attr('y2', y + 4);
  svg.append('text').attr('x', x).attr('y', y + 16).attr('text-anchor', 'middle').text(text);
}

function mapFigure(parent, run, map, scale, view) {
  const kind = mapKinds[map.name];
  const values = mapValues(map);
  const picture = mapPicture(map, values, scale);
  const {relief} = run.terrain;
  const shade = relief ? hillshade(relief) : null;
  const [x0, y0] = map.origin, [dx, dy] = map.cell;
  const id = `map-${run.index}-${map.name}`;
  const [wide, tall] = map.cell.map((side) => givenIn('m', side, 4));
  const cellText = `${wide === tall ? wide : `${wide} × ${tall}`} ${unitIn('m')}`;
  const {unit, per} = displayOf(kind.unit);
  figure(parent, {
    title: single ? kind.title : `${kind.title} · ${run.label}`, label: `Map: ${kind.quantity} in ${unit}`,
    caption: '', width: single ? mapWidth(view) : drawing.half,
    draw(svg, width) {
      const frame = mapFrame(mapRoom(width), view, groundOf(runs, view));
      const {side, toX, toY} = frame;
      const inside = openMap(svg, id, frame);
      if (shade) layRelief(inside, frame, relief, shade);
      tip(layPicture(inside, frame, picture, 'cells', map.origin, [map.columns * dx, map.rows * dy]), (_, event) => {
        const [left, top] = pointIn(svg.node(), event);
        const x = toX.invert(left), y = toY.invert(top);
        const value = values[Math.floor((y - y0) / dy) * map.columns + Math.floor((x - x0) / dx)];
        return `x ${number(x, 7)} m, y ${number(y, 7)} m\n` + (isNumber(value) ? `about ${number(value, 2)} ${unit}` : 'no rock');
      });
      drawReleases(inside, [run], toX, toY, (p) => p.x, (p) => p.y);
      finishMap(inside, frame, run, barriersOf(run));
      const y = side.bottom + 56;
      return noteMap(svg, mapRoom(width), frame, run, [`cells of ${cellText}`, `up to ${measured(map.greatest / per)} ${unit}`], y, drawColours(svg, scale, kind, side.left, y, width === drawing.wide ? 320 : 230));
    },
  });
}

export function mapFigures(parent) {
  const box = element(parent, 'div', null, {class: 'columns maps'});
  const view = mapView();
  for (const name of Object.keys(mapKinds)) {
    const shown = runs.flatMap((run) => run.maps.filter((map) => map.name === name).map((map) => ({run, map})));
    if (!shown.length) continue;
    const scale = mapScale(shown.map(({map}) => map));
    for (const {run, map} of shown) mapFigure(box, run, map, scale, view);
  }
  element(parent, 'p', 'Cells that rocks reached are coloured by class; of a map of 95 %, 95 % of the rocks in a cell have less. Values under the pointer are rounded; the GeoTIFFs in the folder maps are exact. Lines are barriers and collectors; rings are the releases of the trajectories shown. The relief is lit from the upper left.', {class: 'quiet'});
}
