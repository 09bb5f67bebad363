// The slope tools: bench, ditch, berm and regrading, as pure functions. docs/slope-tools.md has the formulas.
//
// All work on a slope on which rocks fall to the right; `shaped` mirrors one on which they fall to the left.

import type { Point2 } from '../api/types';
import { areasBetween, firstX, groundAt, Impossible, lastX, meeting, mirrored, shown, withStretch, type Place, type Slope } from './slope';

export type ToolKind = 'bench' | 'ditch' | 'berm' | 'regrade';
export type Numbers = Record<string, number>;

interface Field {
  key: string;
  title: string;
  unit: 'm' | '°';
  /// What is possible; a station must be on the section.
  least: number;
  most: number;
  isStation?: boolean;
}
const station = (key: string, title: string): Field => ({ key, title, unit: 'm', least: -1e9, most: 1e9, isStation: true });
const length = (key: string, title: string, least = 0.01): Field => ({ key, title, unit: 'm', least, most: 1e4 });
const steepness = (key: string, title: string): Field => ({ key, title, unit: '°', least: 1, most: 90 });

export const fields: Record<ToolKind, readonly Field[]> = {
  bench: [station('x', 'Outer edge at x'), length('width', 'Width'), { key: 'backfall', title: 'Back-fall', unit: '°', least: -45, most: 45 }, steepness('face', 'Face behind it')],
  ditch: [station('x', 'Toe at x'), length('depth', 'Depth'), length('bottom', 'Bottom width', 0), steepness('back', 'Side to the slope'), steepness('fore', 'Side to the road')],
  berm: [station('x', 'Crest at x'), length('height', 'Height'), length('crest', 'Crest width', 0), steepness('up', 'Side to the slope'), steepness('down', 'Side to the road')],
  regrade: [station('x', 'From x'), station('to', 'To x')],
};
/// Regrading to an angle has it as well.
const regradeAngle = steepness('angle', 'Angle');

export const fieldsOf = (kind: ToolKind, numbers: Numbers): readonly Field[] =>
  kind === 'regrade' && numbers.angle !== undefined ? [...fields.regrade, regradeAngle] : fields[kind];

export interface Handle {
  title: string;
  at: Point2;
  /// The numbers if it is dragged to a place.
  moved: (to: Point2) => Numbers;
}
export interface Shaped {
  slope: Slope;
  /// The new ground of the stretch, and where it begins and ends.
  line: Point2[];
  /// Where rocks are to be kept, in the direction in which they fall: the toe and the far edge.
  keeps: [number, number];
  cut: number;
  fill: number;
  handles: Handle[];
}

const cos = (degrees: number) => (degrees === 90 ? 0 : Math.cos((degrees * Math.PI) / 180));
const sin = (degrees: number) => Math.sin((degrees * Math.PI) / 180);
const run = (height: number, degrees: number) => (degrees === 90 ? 0 : height / Math.tan((degrees * Math.PI) / 180));
const positive = (value: number, least = 0.01) => Math.max(least, Number(value.toFixed(2)));
const rough = (value: number) => Number(value.toFixed(2));

/// Throws Impossible for numbers that cannot be.
function check(kind: ToolKind, numbers: Numbers) {
  for (const { key, title, unit, least, most } of fieldsOf(kind, numbers)) {
    const value = numbers[key];
    if (value === undefined || !Number.isFinite(value)) throw new Impossible(`${title}: a number is missing.`);
    if (unit === '°' && value > 90) throw new Impossible(`${title}: ${shown(value)}° is steeper than vertical.`);
    if (value < least || value > most)
      throw new Impossible(`${title}: ${shown(value)} ${unit}; expected ${least} to ${most.toLocaleString('en')} ${unit}.`);
  }
}

interface Made {
  start: Place;
  middle: Point2[];
  end: Place;
  keeps: [number, number];
  handles: Handle[];
}

function isUnder(slope: Slope, [x, z]: Point2): boolean {
  if (x < firstX(slope) || x > lastX(slope)) throw new Impossible(`It does not fit: x = ${shown(x)} is off the section.`);
  return z < groundAt(slope, x, 'high').point[1];
}

function bench(slope: Slope, numbers: Numbers): Made {
  const { x, width, backfall, face } = numbers as Record<'x' | 'width' | 'backfall' | 'face', number>;
  const outer = groundAt(slope, x, 'high');
  const inner: Point2 = [x - width, outer.point[1] - width * Math.tan((backfall * Math.PI) / 180)];
  if (!isUnder(slope, inner)) throw new Impossible('The ground does not rise behind the edge: a bench there would be a fill. Move it, or make the back-fall larger.');
  const top = meeting(slope, inner, [-cos(face), sin(face)]);
  if (!top) throw new Impossible('The face behind the bench does not reach the ground. Make it steeper, or the bench narrower.');
  return {
    start: top,
    middle: [inner],
    end: outer,
    keeps: [inner[0], x],
    handles: [
      { title: 'Outer edge', at: outer.point, moved: ([to]) => ({ ...numbers, x: rough(to) }) },
      { title: 'Width', at: inner, moved: ([to]) => ({ ...numbers, width: positive(x - to) }) },
    ],
  };
}

function ditch(slope: Slope, numbers: Numbers): Made {
  const { x, depth, bottom, back, fore } = numbers as Record<'x' | 'depth' | 'bottom' | 'back' | 'fore', number>;
  const toe = groundAt(slope, x, 'low');
  const level = toe.point[1] - depth;
  const near: Point2 = [x + run(depth, back), level];
  const far: Point2 = [near[0] + bottom, level];
  if (!isUnder(slope, near) || !isUnder(slope, far)) throw new Impossible('The bottom would be above the ground, which falls away here. Make the ditch deeper or narrower, or move its toe.');
  const edge = meeting(slope, far, [cos(fore), sin(fore)]);
  if (!edge) throw new Impossible('The side to the road does not reach the ground before the section ends. Make it steeper, or the ditch narrower.');
  return {
    start: toe,
    middle: bottom > 0 ? [near, far] : [near],
    end: edge,
    keeps: [x, edge.point[0]],
    handles: [
      { title: 'Toe', at: toe.point, moved: ([to]) => ({ ...numbers, x: rough(to) }) },
      {
        title: 'Depth and width',
        at: far,
        moved: ([to, z]) => {
          const deep = positive(toe.point[1] - z);
          return { ...numbers, depth: deep, bottom: positive(to - x - run(deep, back), 0) };
        },
      },
    ],
  };
}

function berm(slope: Slope, numbers: Numbers): Made {
  const { x, height, crest, up, down } = numbers as Record<'x' | 'height' | 'crest' | 'up' | 'down', number>;
  const level = groundAt(slope, x, 'high').point[1] + height;
  const [near, far]: [Point2, Point2] = [[x - crest / 2, level], [x + crest / 2, level]];
  if (isUnder(slope, near) || isUnder(slope, far)) throw new Impossible('The crest would be inside of the slope. Make the berm higher or narrower, or move it away from the slope.');
  const [first, last] = [meeting(slope, near, [-cos(up), -sin(up)]), meeting(slope, far, [cos(down), -sin(down)])];
  if (!first || !last) throw new Impossible(`The side to the ${first ? 'road' : 'slope'} does not reach the ground. Make it steeper.`);
  return {
    start: first,
    middle: crest > 0 ? [near, far] : [near],
    end: last,
    keeps: [first.point[0], last.point[0]],
    handles: [
      {
        title: 'Crest',
        at: [x, level],
        moved: ([to, z]) => {
          const at = Math.min(Math.max(rough(to), firstX(slope)), lastX(slope));
          return { ...numbers, x: at, height: positive(z - groundAt(slope, at, 'high').point[1]) };
        },
      },
      { title: 'Crest width', at: far, moved: ([to]) => ({ ...numbers, crest: positive(2 * (to - x), 0) }) },
    ],
  };
}

function regrade(slope: Slope, numbers: Numbers): Made {
  const { x, to, angle } = numbers as Record<'x' | 'to', number> & { angle?: number };
  if (!(to - x >= 0.01)) throw new Impossible('The first place must be uphill of the second one.');
  const [from, end] = [groundAt(slope, x, 'high'), groundAt(slope, to, 'low')];
  let start = from;
  if (angle !== undefined) {
    const met = meeting(slope, end.point, [-cos(angle), sin(angle)]);
    if (!met || met.point[0] < x) throw new Impossible(`A slope of ${shown(angle)}° from the second place does not reach the ground before the first one.`);
    start = met;
  }
  return {
    start,
    middle: [],
    end,
    keeps: [start.point[0], to],
    handles: [
      { title: 'From', at: from.point, moved: ([at]) => ({ ...numbers, x: rough(at) }) },
      { title: 'To', at: end.point, moved: ([at]) => ({ ...numbers, to: rough(at) }) },
    ],
  };
}

const makers: Record<ToolKind, (slope: Slope, numbers: Numbers) => Made> = { bench, ditch, berm, regrade };
/// What each tool may do: a bench and a ditch only cut, a berm only fills.
const only: Partial<Record<ToolKind, 'cut' | 'fill'>> = { bench: 'cut', ditch: 'cut', berm: 'fill' };
const negligible = 1e-4; // of rounding [m2]

function shapedRight(kind: ToolKind, numbers: Numbers, slope: Slope): Shaped {
  check(kind, numbers);
  const { start, middle, end, keeps, handles } = makers[kind](slope, numbers);
  const next = withStretch(slope, start, middle, end);
  const { cut, fill } = areasBetween(slope, next);
  if (only[kind] === 'cut' && fill > negligible) throw new Impossible('A part of it would be above the ground. Make its sides steeper, or move it.');
  if (only[kind] === 'fill' && cut > negligible) throw new Impossible('A part of it would be inside of the slope. Make its sides steeper, or move it.');
  return { slope: next, line: [start.point, ...middle, end.point], keeps, cut, fill, handles };
}

const minus = (x: number) => (x === 0 ? 0 : -x);
const flipped = ([x, z]: Point2): Point2 => [minus(x), z];
/// Stations of the mirrored slope.
export function flippedNumbers(kind: ToolKind, numbers: Numbers): Numbers {
  const stations = fields[kind].filter(({ isStation }) => isStation).map(({ key }) => key);
  return Object.fromEntries(Object.entries(numbers).map(([key, value]) => [key, stations.includes(key) ? minus(value) : value]));
}

/// The slope with a tool's numbers. Throws Impossible, with a message for the user.
export function shaped(kind: ToolKind, numbers: Numbers, slope: Slope, fallsLeft: boolean): Shaped {
  if (!fallsLeft) return shapedRight(kind, numbers, slope);
  const made = shapedRight(kind, flippedNumbers(kind, numbers), mirrored(slope));
  return {
    ...made,
    slope: mirrored(made.slope),
    line: made.line.map(flipped),
    keeps: [minus(made.keeps[0]), minus(made.keeps[1])],
    handles: made.handles.map(({ title, at, moved }) => ({ title, at: flipped(at), moved: (to) => flippedNumbers(kind, moved(flipped(to))) })),
  };
}

/// Where the ground first has an elevation, from the top of the slope on.
export function stationAt(slope: Slope, z: number, fallsLeft: boolean): number {
  const right = fallsLeft ? mirrored(slope) : slope;
  const met = meeting(right, [firstX(right) - 1, z], [1, 0]);
  if (!met) throw new Impossible(`The section has no ground at z = ${shown(z)} m.`);
  return Number((fallsLeft ? -met.point[0] : met.point[0]).toFixed(3));
}

/// Whether rocks fall to the left: the left end of the section is the lower one.
export const fallsLeft = ({ vertices }: Slope) => vertices[0]![1] < vertices.at(-1)![1];

/// The foot of the slope, at which a ditch begins: the lower end of the last steep part that is at least half as high as
/// the highest one.
function footOf({ vertices }: Slope): number {
  let height = 0;
  const ends = vertices.slice(1).map(([x, z], k) => {
    const [above, beside] = [vertices[k]![1] - z, x - vertices[k]![0]];
    height = above > 0.5 * beside ? height + above : 0;
    return { x, height };
  });
  const most = Math.max(...ends.map((end) => end.height));
  const middle = vertices[Math.floor(vertices.length / 2)]!;
  return most > 0 ? ends.findLast((end) => end.height >= 0.5 * most)!.x : middle[0];
}

/// A bench in the middle of the longest part of the slope that has room for it.
function usualBench(slope: Slope, unit: number): Numbers {
  const { vertices } = slope;
  const parts = vertices.slice(1).map(([x, z], k) => ({ x: (x + vertices[k]![0]) / 2, height: vertices[k]![1] - z }));
  const tries = parts.sort((a, b) => b.height - a.height).flatMap(({ x }) => [1, 0.5, 0.2].map((share) => ({ x: rough(x), width: rough(share * unit), backfall: 5, face: 80 })));
  const fits = (numbers: Numbers) => {
    try {
      return shapedRight('bench', numbers, slope).cut > 0;
    } catch {
      return false;
    }
  };
  return tries.slice(0, 30).find(fits) ?? tries[0]!;
}

/// Numbers to begin with, in proportion to the section.
export function usualNumbers(kind: ToolKind, slope: Slope, isLeft: boolean): Numbers {
  const right = isLeft ? mirrored(slope) : slope;
  const [from, to] = [firstX(right), lastX(right)];
  const foot = footOf(right);
  const unit = Math.min(Math.max(rough((to - from) / 20), 0.5), 5);
  const inside = (x: number) => rough(Math.min(Math.max(x, from + unit), to - unit));
  const numbers: Record<ToolKind, Numbers> = {
    bench: usualBench(right, unit),
    ditch: { x: foot, depth: rough(unit / 4), bottom: unit, back: 60, fore: 25 },
    berm: { x: inside(foot + 2.5 * unit), height: unit, crest: rough(unit / 2), up: 60, down: 35 },
    regrade: { x: inside(foot - 3 * unit), to: inside(foot) },
  };
  return isLeft ? flippedNumbers(kind, numbers[kind]) : numbers[kind];
}
