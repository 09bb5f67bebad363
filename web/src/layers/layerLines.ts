// The lines of a vector layer as the server sends them.

import type { Arrays } from '../api/arrays';

export interface LinesHeader {
  origin: [number, number, number];
  names: string[];
  kinds: string[];
}

export interface LayerLines {
  /// Pairs of points, relative to `origin`.
  segments: Float32Array;
  points: Float32Array;
  origin: [number, number, number];
  /// The longest line of each name: the point in its middle.
  names: { text: string; at: [number, number, number] }[];
}

/// At most this many names are placed.
const mostNames = 300;

export function linesOf({ header, arrays }: Arrays<LinesHeader>): LayerLines {
  const [positions, starts, names, kinds] = ['positions', 'starts', 'names', 'kinds'].map((key) => arrays[key]!) as [
    Float32Array,
    Uint32Array,
    Uint32Array,
    Uint8Array,
  ];
  const count = positions.length / 3;
  const point = header.kinds.indexOf('point');
  const segments: number[] = [];
  const points: number[] = [];
  const longest = new Map<number, { length: number; from: number; to: number }>();
  starts.forEach((from, k) => {
    const to = starts[k + 1] ?? count;
    if (kinds[k] === point) points.push(...positions.subarray(3 * from, 3 * to));
    else
      for (let i = from; i + 1 < to; ++i) segments.push(...positions.subarray(3 * i, 3 * i + 6));
    const length = to - from;
    const name = names[k]!;
    if (name > 0 && length > (longest.get(name)?.length ?? 0)) longest.set(name, { length, from, to });
  });
  const placed = [...longest].sort(([, a], [, b]) => b.length - a.length).slice(0, mostNames);
  return {
    segments: new Float32Array(segments),
    points: new Float32Array(points),
    origin: header.origin,
    names: placed.map(([name, { from, to }]) => {
      const middle = 3 * Math.floor((from + to - 1) / 2);
      return { text: header.names[name]!, at: [positions[middle]!, positions[middle + 1]!, positions[middle + 2]!] };
    }),
  };
}
