// Paths of rocks as seen from the side, over the ground: the same view for several rock models.

import { line } from 'd3-shape';
import type { SidePlace, SideView } from '../archive/modelComparison';
import { openDrawing, openPlot, sign, type Range, type Room } from './plot';
import { rockModelTitle } from './rockModels';

/// Beside the colours, for print in grey.
const dashes: Record<string, string> = { rigid_sphere: '8 3', rigid_body: '2 3' };

/// Colours of the models, which also those tell apart who do not see red and green.
export const modelColours: Record<string, string> = {
  lumped_mass: '#0072b2',
  rigid_sphere: '#d55e00',
  rigid_body: '#009e73',
};

/// What all sets together reach.
export function rangesOf({ ground, sets }: SideView): { s: Range; z: Range } {
  const s: Range = [Infinity, -Infinity];
  const z: Range = [Infinity, -Infinity];
  const grow = (range: Range, value: number) => {
    range[0] = Math.min(range[0], value);
    range[1] = Math.max(range[1], value);
  };
  for (const path of [ground, ...sets.flatMap(({ paths }) => paths)]) {
    for (const place of path) {
      if (!place) continue;
      grow(s, place[0]);
      grow(z, place[1]);
    }
  }
  return s[0] <= s[1] ? { s, z } : { s: [0, 1], z: [0, 1] };
}

/// The ranges for a plot area of this size, with the same scale along both axes.
export function evenly({ s, z }: { s: Range; z: Range }, width: number, height: number): [Range, Range] {
  const perUnit = Math.max((s[1] - s[0]) / width, (1.08 * (z[1] - z[0])) / height, 1e-9);
  const [sMiddle, zMiddle] = [(s[0] + s[1]) / 2, (z[0] + z[1]) / 2];
  return [
    [sMiddle - (perUnit * width) / 2, sMiddle + (perUnit * width) / 2],
    [zMiddle - (perUnit * height) / 2, zMiddle + (perUnit * height) / 2],
  ];
}

/// Draws the set at `which`. `unit` and `per`: of lengths.
export function sideView(element: SVGSVGElement, room: Room, { of, which, unit, per }: { of: SideView; which: number; unit: string; per: number }) {
  const svg = openDrawing(element, room);
  const { model, paths } = of.sets[which]!;
  const colour = modelColours[model] ?? '#555';
  const inUnit = ([low, high]: Range): Range => [low / per, high / per];
  const ranges = rangesOf(of);
  const all = { s: inUnit(ranges.s), z: inUnit(ranges.z) };
  const { x, y } = openPlot(svg, room, {
    x: all.s,
    y: all.z,
    fit: (width, height) => evenly(all, width, height),
    xLabel: `${of.is_section ? 'x' : 'Along the mean way of the rocks'} [${unit}]`,
    yLabel: `Elevation [${unit}]`,
    entries: [
      { text: `${rockModelTitle(model)}, ${paths.length} rocks`, draw: sign.line('model-path', colour) },
      { text: of.is_section ? 'Ground' : 'Ground along that way', draw: sign.line('model-ground') },
    ],
  });
  const drawn = line<SidePlace | null>()
    .defined((place) => place !== null)
    .x((place) => x(place![0] / per))
    .y((place) => y(place![1] / per));
  svg.append('path').attr('class', of.is_section ? 'model-ground' : 'model-ground beside').attr('d', drawn(of.ground));
  for (const path of paths) svg.append('path').attr('class', 'model-path').style('--run', colour).attr('d', drawn(path));
}

/// For each set the share of its rocks that go at least so far, in percent.
export function reach(element: SVGSVGElement, room: Room, { of, unit, per }: { of: SideView; unit: string; per: number }) {
  const svg = openDrawing(element, room);
  const farthest = Math.max(...of.sets.map(({ runout_m }) => runout_m.at(-1) ?? 0), 1e-9) / per;
  const { x, y } = openPlot(svg, room, {
    x: [0, 1.04 * farthest],
    y: [0, 104],
    xLabel: `Runout on plan [${unit}]`,
    yLabel: 'Rocks that go at least so far [%]',
    entries: of.sets.map(({ model }) => ({
      text: rockModelTitle(model),
      draw: sign.line('curve', modelColours[model] ?? '#555', dashes[model] ?? ''),
    })),
  });
  for (const { model, runout_m } of of.sets) {
    const curve = line<readonly [number, number]>()
      .x(([runout]) => x(runout))
      .y(([, share]) => y(share));
    const last = Math.max(runout_m.length - 1, 1);
    const points = runout_m.map((runout, k): [number, number] => [runout / per, 100 * (1 - k / last)]);
    svg
      .append('path')
      .attr('class', 'curve')
      .style('--run', modelColours[model] ?? '#555')
      .style('stroke-dasharray', dashes[model] ?? '')
      .attr('d', curve([[0, 100], ...points]));
  }
}
