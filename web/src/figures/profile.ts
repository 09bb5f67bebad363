// The ground along a line, with gaps where there is no terrain.

import { extentOf, openDrawing, openPlot, readAlong, type Range, type Room } from './plot';

export interface Profile {
  /// Ascending [m].
  distance: readonly number[];
  /// Null: no terrain from here to the next point.
  z: readonly (number | null)[];
  colour: string;
  /// Ranges of both axes for a plot area of this size, if they are to have the same scale.
  fit?: ((width: number, height: number) => [Range, Range]) | undefined;
  textOf: (k: number) => string;
  hover: (k: number | null) => void;
}

export function profile(element: SVGSVGElement, room: Room, { distance, z, colour, fit, textOf, hover }: Profile) {
  const svg = openDrawing(element, room);
  const plot = openPlot(svg, room, {
    x: [0, distance.at(-1) ?? 1],
    y: extentOf(
      z.filter((value) => value !== null),
      0.06,
    ),
    ...(fit && { fit }),
    xLabel: 'Distance along the line [m]',
    yLabel: 'Elevation [m]',
  });
  const { x, y, side } = plot;
  let pieces: string[] = [];
  const group = svg.append('g').style('--run', colour);
  const close = (last: number) => {
    if (pieces.length > 1) {
      const line = `M${pieces.join('L')}`;
      const first = x(distance[last - pieces.length + 1]!).toFixed(2);
      group.append('path').attr('class', 'below-curve').attr('d', `${line}V${side.bottom}H${first}Z`);
      group.append('path').attr('class', 'curve').attr('d', line);
    }
    pieces = [];
  };
  z.forEach((value, k) => {
    if (value === null) close(k - 1);
    else pieces.push(`${x(distance[k]!).toFixed(2)},${y(value).toFixed(2)}`);
  });
  close(z.length - 1);
  return readAlong(svg, plot, distance, textOf, hover);
}
