// The ground along a line, with gaps where there is no terrain, and what passes over it: trajectories beside the line, and
// an envelope of another quantity with its own axis.

import { extentOf, fromZero, openDrawing, openPlot, readAlong, sign, type Group, type Range, type Room, type Scale } from './plot';

/// Polylines of one colour: distance along the line and elevation of each point [m].
export interface Traces {
  /// A CSS colour.
  colour: string;
  lines: readonly (readonly (readonly [number, number])[])[];
}

/// A quantity at stations along the line; null where nothing passes.
export interface AlongLine {
  /// With its unit.
  label: string;
  /// Ascending [m].
  stations: readonly number[];
  curves: readonly { name: string; dash: string; values: readonly (number | null)[] }[];
}

export interface Profile {
  /// Ascending [m].
  distance: readonly number[];
  /// Null: no terrain from here to the next point.
  z: readonly (number | null)[];
  colour: string;
  traces?: readonly Traces[];
  envelope?: AlongLine | null;
  /// Ranges of both axes for a plot area of this size, if they are to have the same scale.
  fit?: ((width: number, height: number) => [Range, Range]) | undefined;
  textOf: (k: number) => string;
  hover: (k: number | null) => void;
}

/// The ranges of what is drawn.
export function extentOfProfile({ distance, z, traces = [] }: Pick<Profile, 'distance' | 'z' | 'traces'>): [Range, Range] {
  let [low, high] = [Infinity, -Infinity];
  const take = (height: number) => ([low, high] = [Math.min(low, height), Math.max(high, height)]);
  for (const height of z) if (height !== null) take(height);
  for (const { lines } of traces) for (const line of lines) for (const [, height] of line) take(height);
  return [[0, distance.at(-1) ?? 1], low <= high ? [low, high] : [0, 1]];
}

/// The line without points that would be drawn at the pixel of the one before.
function tracePath(line: readonly (readonly [number, number])[], x: Scale, y: Scale): string {
  let [text, lastX, lastY] = ['', NaN, NaN];
  line.forEach(([distance, height], k) => {
    const [left, top] = [x(distance), y(height)];
    if (k > 0 && k < line.length - 1 && Math.abs(left - lastX) + Math.abs(top - lastY) < 0.8) return;
    text += `${k === 0 ? 'M' : 'L'}${left.toFixed(1)},${top.toFixed(1)}`;
    [lastX, lastY] = [left, top];
  });
  return text;
}

function envelopeCurve(stations: readonly number[], values: readonly (number | null)[], x: Scale, y: Scale): string {
  return values
    .map((value, k) => {
      if (value === null) return '';
      const isBroken = k === 0 || values[k - 1] === null;
      return `${isBroken ? 'M' : 'L'}${x(stations[k]!).toFixed(1)},${y(value).toFixed(1)}${isBroken ? 'h0.01' : ''}`;
    })
    .join('');
}

export function profile(element: SVGSVGElement, room: Room, shown: Profile) {
  const { distance, z, colour, traces = [], envelope = null, fit, textOf, hover } = shown;
  const svg = openDrawing(element, room);
  const [along, heights] = extentOfProfile(shown);
  const curves = (envelope?.curves ?? []).map((curve) => ({ ...curve, group: svg.append('g') as Group }));
  const plot = openPlot(svg, room, {
    x: along,
    y: extentOf(heights, 0.06),
    ...(fit && { fit }),
    xLabel: 'Distance along the line [m]',
    yLabel: 'Elevation [m]',
    entries: curves.map(({ name, dash, group }) => ({ text: name, draw: sign.line('envelope above', '', dash), switches: group })),
    second: envelope
      ? { range: fromZero(curves.flatMap(({ values }) => values.filter((value) => value !== null))), label: envelope.label }
      : undefined,
  });
  const { x, y, side, second } = plot;
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
  for (const { colour: own, lines } of traces)
    svg
      .append('path')
      .attr('class', 'trace')
      .style('--run', own)
      .attr('d', lines.map((line) => tracePath(line, x, y)).join(''));
  if (envelope && second)
    for (const { dash, values, group: own } of curves)
      own
        .raise()
        .append('path')
        .attr('class', 'envelope above')
        .style('stroke-dasharray', dash || 'none')
        .attr('d', envelopeCurve(envelope.stations, values, x, second));
  return readAlong(svg, plot, distance, textOf, hover);
}
