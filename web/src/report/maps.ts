// Maps of results over the shaded relief, with barriers and releases: bounce height, energy, velocity, reach probability.

import * as d3 from '../figures/d3';
import { pointIn, type Group } from '../figures/plot';
import { tip } from '../figures/tip';
import type { MapData } from './data';
import { drawing, element, figure } from './figure';
import { displayOf, givenIn, isNumber, measured, number, unitIn } from './format';
import { finishMap, groundOf, layPicture, layRelief, mapFrame, noteMap, openMap } from './mapframe';
import { mapKinds, type MapKind } from './mapKinds';
import { mapRoom, mapWidth, viewOf, type View } from './mapRoom';
import { gridPicture, hillshade } from './relief';
import { drawReleases } from './rocks';
import { barrierLine, barriersOf, page, runs, single, type Run } from './run';
import { releasesOf, type Point } from './travel';

// A map's values in the displayed unit, row by row from the south; null where no rock passed.
function valuesOf({ logarithmic, least, greatest, levels }: MapData, { unit }: MapKind): (number | null)[] {
  const { per } = displayOf(unit);
  const value = (part: number) => (logarithmic ? least * (greatest / least) ** part : greatest * part) / per;
  return Array.from(atob(levels), (letter) => {
    const level = letter.charCodeAt(0);
    return level === 0 ? null : value((level - 1) / 254);
  });
}

/// The classes of the maps of one kind, the same in every run: lower limits above the first in the displayed unit.
interface Classes {
  limits: number[];
  colours: [number, number, number][];
}

function pictureOf({ columns, rows }: MapData, values: readonly (number | null)[], { limits, colours }: Classes): string {
  const picture = gridPicture(columns, rows, (column, row) => {
    const value = values[row * columns + column];
    const colour = isNumber(value) ? colours[d3.bisectRight(limits, value)] : undefined;
    return colour ? [...colour, 215] : null;
  });
  return picture.toDataURL('image/png');
}

// The extent of all maps, the same for both runs: their cells, barriers and releases.
function viewOfMaps(): View {
  const cells = runs.flatMap(({ maps }) =>
    maps.flatMap(({ origin: [x, y], cell: [dx, dy], columns, rows }): Point[] => [
      [x, y],
      [x + columns * dx, y + rows * dy],
    ]),
  );
  const releases = runs.flatMap(releasesOf).map(({ x, y }): Point => [x, y]);
  return viewOf([...cells, ...runs.flatMap(barriersOf).flatMap(barrierLine), ...releases], 0.04);
}

function drawTick(svg: Group, x: number, y: number, text: string) {
  svg.append('line').attr('class', 'tick-mark').attr('x1', x).attr('x2', x).attr('y1', y).attr('y2', y + 4);
  svg.append('text').attr('x', x).attr('y', y + 16).attr('text-anchor', 'middle').text(text);
}

// Draws a bar of the classes with their limits below. Returns the y of its end.
function drawColours(svg: Group, { limits, colours }: Classes, title: string, [x, y]: Point, width: number): number {
  const each = width / colours.length;
  const height = 12;
  svg.append('text').attr('x', x).attr('y', y).text(title);
  colours.forEach((colour, k) => {
    const box = svg.append('rect').attr('class', 'map-class').attr('fill', d3.rgb(...colour).toString());
    box.attr('x', x + k * each).attr('y', y + 8).attr('width', each).attr('height', height);
  });
  limits.forEach((limit, k) => drawTick(svg, x + (k + 1) * each, y + 8 + height, number(limit, 3)));
  return y + 8 + height + 22;
}

function cellText({ cell }: MapData): string {
  const [wide, tall] = cell.map((side) => givenIn('m', side, 4));
  return `cells of ${wide === tall ? wide : `${wide} × ${tall}`} ${unitIn('m')}`;
}

function mapFigure(parent: Group, run: Run, map: MapData, kind: MapKind, classes: Classes, view: View) {
  const values = valuesOf(map, kind);
  const picture = pictureOf(map, values, classes);
  const { relief } = run.terrain;
  const shade = relief && hillshade(relief);
  const { origin, cell, columns, rows } = map;
  const { unit, per } = displayOf(kind.unit);
  const textAt = (x: number, y: number) => {
    const value = values[Math.floor((y - origin[1]) / cell[1]) * columns + Math.floor((x - origin[0]) / cell[0])];
    return `x ${number(x, 7)} m, y ${number(y, 7)} m\n${isNumber(value) ? `about ${number(value, 2)} ${unit}` : 'no rock'}`;
  };
  figure(parent, {
    title: single ? kind.title : `${kind.title} · ${run.label}`,
    label: `Map: ${kind.quantity} in ${unit}`,
    caption: '',
    width: single ? mapWidth(view) : drawing.half,
    draw(svg, width) {
      const room = mapRoom(width);
      const frame = mapFrame(room, view, groundOf(runs, view));
      const { side, toX, toY } = frame;
      const inside = openMap(svg, `map-${run.index}-${map.name}`, frame);
      if (relief && shade) layRelief(inside, frame, relief, shade);
      const cells = layPicture(inside, frame, picture, 'cells', origin, [columns * cell[0], rows * cell[1]]);
      tip(cells, (_, event) => {
        const [x, y] = pointIn(svg.node(), event);
        return textAt(toX.invert(x), toY.invert(y));
      });
      drawReleases(inside, [run], ({ x, y }) => [toX(x), toY(y)]);
      finishMap(inside, frame, run, barriersOf(run));
      const y = side.bottom + 56;
      const title = `${kind.quantity} [${unit}]`;
      const lowest = drawColours(svg, classes, title, [side.left, y], width === drawing.wide ? 320 : 230);
      const more = [cellText(map), `up to ${measured(map.greatest / per)} ${unit}`];
      return noteMap(svg, room, frame, { run, more, y, lowest });
    },
  });
}

const explanation =
  'Cells that rocks reached are coloured by class; of a map of 95 %, 95 % of the rocks in a cell have less. ' +
  'Values under the pointer are rounded; the GeoTIFFs in the folder maps are exact. Lines are barriers and ' +
  'collectors; rings are the releases of the trajectories shown. The relief is lit from the upper left.';

export function mapFigures(parent: Group) {
  const box = element(parent, 'div', null, { class: 'columns maps' });
  const view = viewOfMaps();
  for (const kind of mapKinds) {
    const shown = runs.flatMap((run) => run.maps.filter(({ name }) => name === kind.name).map((map) => ({ run, map })));
    const { per } = displayOf(kind.unit);
    const classes = { limits: (shown[0]?.map.limits ?? []).map((limit) => limit / per), colours: page.map_colours };
    for (const { run, map } of shown) mapFigure(box, run, map, kind, classes, view);
  }
  element(parent, 'p', explanation, { class: 'quiet' });
}
