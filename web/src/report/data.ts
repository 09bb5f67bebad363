// The data that the engine embeds in a report (src/talus/report/report.cpp).

import type { ObservedComparison } from '../archive/observed';
import type { SummaryOf } from '../archive/summary';
import type { Convergence, Uncertainty } from '../archive/uncertainty';

/// Rows of a file with the names of their columns.
interface Table {
  columns: string[];
  rows: unknown[][];
}

/// A map in levels: 0 without a rock; k from 1 to 255 stands for least (greatest / least)^((k - 1) / 254) if it is
/// logarithmic, and for greatest (k - 1) / 254 if not.
export interface MapData {
  name: string;
  logarithmic: boolean;
  least: number;
  greatest: number;
  /// Lower limits of the classes above the first.
  limits: number[];
  /// The south-western corner, and the size of a cell [m].
  origin: [number, number];
  cell: [number, number];
  columns: number;
  rows: number;
  /// Base64, row by row from the south.
  levels: string;
}

/// Observed stops, and what they are compared by.
export interface ObservedData extends ObservedComparison {
  stops: Table;
}

export interface RunData {
  folder: string;
  date: string;
  summary: SummaryOf<number>;
  endpoints: Table & { has_file: boolean; total: number };
  paths: { has_file: boolean; total: number; columns: string[]; rocks: { rock: number; rows: unknown[][] }[] };
  hits: Table & { has_file: boolean; total: number };
  losses: Table & { of_shown_paths: number; by_number_columns: string[]; by_number: unknown[][] };
  maps: MapData[];
  envelopes: Table & { cells_each: number };
  convergence: Convergence;
  uncertainty: Uncertainty;
  notes: string[];
  observed?: ObservedData;
}

export interface PageData {
  version: string;
  /// Red, green and blue of the classes of maps.
  map_colours: [number, number, number][];
  runs: RunData[];
}

/// What the rows of the tables become.
export interface EndPoint {
  rock: number;
  seeder: number;
  x: number;
  y: number;
  z: number;
  runout_xy: number;
  runout_total: number;
  time: number;
  end_reason: string;
  max_ke: number;
  max_bounce: number;
  /// Of blocks: the lengths of their axes, and the share of spin about the shortest.
  a?: number | null;
  b?: number | null;
  c?: number | null;
  share?: number | null;
}
export interface PathRow {
  state: string;
  time: number;
  x: number;
  y: number;
  z: number;
  vx: number;
  vy: number;
  vz: number;
  ke_translational: number;
  ke_rotational: number;
  pe: number;
}
/// A rock with its trajectory.
export interface Rock {
  rock: number;
  /// The place of its run on the page.
  run: number;
  rows: PathRow[];
}
export interface Hit {
  barrier: string;
  rock: number;
  time: number;
  x: number;
  y: number;
  z: number;
  height: number;
  angle: number;
  ke_translational: number;
  ke_total: number;
  outcome: string;
}
export interface Loss {
  rock: number;
  impact: number;
  x: number;
  travelled: number;
  lost: number;
  kinetic_before: number;
}
export interface LossByNumber {
  impact: number;
  rocks: number;
  mean: number;
  least: number;
  most: number;
}
export interface Stop {
  x: number;
  y: number;
  z: number | null;
  name: string;
  mass_kg: number | null;
}

/// The rows of a table as objects keyed by its columns.
export const records = <Row>({ columns, rows }: Table): Row[] =>
  rows.map((row) => Object.fromEntries(columns.map((name, k) => [name, row[k]])) as Row);

/// The data that the page carries.
export const embedded = <Data>(): Data => JSON.parse(document.getElementById('data')!.textContent!) as Data;
