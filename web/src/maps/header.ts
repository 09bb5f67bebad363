// What the server says of a map's picture.

import type { Point2 } from '../api/types';
import type { MapClass } from './classes';

export interface MapHeader {
  origin: Point2; // the south-western corner
  cell: Point2;
  columns: number;
  rows: number;
  /// The same for every map of this kind, in the unit of the file.
  classes: MapClass[];
}
