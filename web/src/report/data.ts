// The data that the engine embeds in a report (src/talus/report/report.cpp).

import type { SummaryOf } from '../archive/summary';

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

/// Number of rocks, value, and the ends of its interval.
export type ConvergenceStep = [number, number, number | null, number | null];
/// A figure of the whole run, or at a line.
export interface NamedFigure {
  line: string;
  text: string;
  /// Empty: a share.
  unit: string;
}
export interface FigureConvergence extends NamedFigure {
  steps: ConvergenceStep[];
  rocks_needed: number | null;
}
/// Value, low and high end.
export type Ends = [number, number, number];
export interface FigureUncertainty extends NamedFigure {
  ensembles: number;
  total: Ends;
  parameters: Ends;
  rocks: Ends;
  /// Of the variance between ensembles.
  parameter_share: number;
}

/// Observed stops, and distances between them and the simulated ones, beside what chance alone gives.
export interface ObservedData {
  file: string;
  stops: Table;
  rocks: number;
  draws: number;
  /// How runout is measured; null: not at all.
  runout: string | null;
  quantities: ObservedQuantity[];
}
/// A distance between simulated and observed rocks, the median and the 95th percentile of the same by chance, and the
/// share of draws that are as far.
export interface ObservedDistance {
  value: number;
  median: number;
  p95: number;
  p_value: number;
}
export interface ObservedFacts {
  mean: number;
  p05: number;
  median: number;
  p95: number;
  /// Values with the share of rocks up to each.
  cumulative: [number, number][];
}
/// All lengths are in metres.
export interface ObservedQuantity {
  key: 'position' | 'x' | 'runout' | 'lateral';
  energy_distance: ObservedDistance;
  /// Of a position on plan missing, as are all below.
  kolmogorov_smirnov?: ObservedDistance;
  simulated?: ObservedFacts;
  observed?: ObservedFacts;
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
  convergence: { confidence: number; tolerance: number; figures: FigureConvergence[] };
  uncertainty: { ensembles: number; confidence: number; figures: FigureUncertainty[] };
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
