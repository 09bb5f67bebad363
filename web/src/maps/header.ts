// The header of a map from the server.

import type { Point2 } from '../api/types';
import type { MapClass } from './classes';

export interface MapHeader {
  origin: Point2; // the south-western corner
  cell: Point2;
  columns: number;
  rows: number;
  /// The same for all maps of this quantity, in the unit of the file.
  classes: MapClass[];
}
