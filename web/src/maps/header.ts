// What the server says of a map's picture.

import type { Point2 } from '../api/types';
import type { Colour } from '../view/colours';
import type { MapClass } from './classes';

export interface MapHeader {
  origin: Point2; // the south-western corner
  cell: Point2;
  columns: number;
  rows: number;
}

// ColorBrewer's YlOrRd: ordered by lightness, and told apart by those who do not tell red from green.
const colours: Colour[] = [
  [0xff, 0xff, 0xb2],
  [0xfe, 0xd9, 0x76],
  [0xfe, 0xb2, 0x4c],
  [0xfd, 0x8d, 0x3c],
  [0xf0, 0x3b, 0x20],
  [0xbd, 0x00, 0x26],
];
const limitsOf: readonly (readonly [string, readonly number[]])[] = [
  ['energy', [30, 100, 300, 1000, 3000]], // kJ
  ['velocity', [5, 10, 15, 20, 30]],
  ['bounce_height', [0.5, 1, 2, 5, 10]],
  ['reach_share', [1e-5, 1e-4, 1e-3, 1e-2, 1e-1]],
  ['', [10, 100, 1000, 10_000, 100_000]],
];

export function classesOf(_header: MapHeader, name: string, _per: number): MapClass[] {
  const limits = limitsOf.find(([begin]) => name.replace(/^.*\//, '').startsWith(begin))![1];
  return colours.map((colour, k) => ({ from: k === 0 ? 0 : limits[k - 1]!, to: limits[k] ?? null, colour }));
}
