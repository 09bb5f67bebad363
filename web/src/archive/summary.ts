// summary.json of a run, as the engine writes it (src/talus/archive/run_summary.hpp). `N` is what numbers are read as:
// numbers, or their texts as in the file.

/// Descriptive statistics of one quantity, by their names in the file; null: too few values.
export interface FiguresOf<N> {
  count: N;
  quartiles?: (N | null)[];
  /// By percent.
  percentiles?: Record<string, N | null>;
  [figure: string]: N | null | undefined | (N | null)[] | Record<string, N | null>;
}

/// Counts of values in bins from `low`, each `width` wide.
export interface HistogramOf<N> {
  low: N;
  width: N;
  counts: N[];
}

/// A setting as in the complete project of a run.
export type Setting = string | number | boolean | null | undefined | readonly Setting[] | { readonly [key: string]: Setting };
/// A table of settings, such as [analysis] or one [[material]].
export type Settings = Readonly<Record<string, Setting>>;
/// Complete, with defaults: tables by name, repeated tables as lists.
export type Project = Readonly<Record<string, Settings | readonly Settings[]>>;

/// The entries of a repeated table, such as [[material]]; none if it is missing.
export function entriesIn(project: Readonly<Record<string, unknown>>, table: string): readonly Settings[] {
  const found = project[table];
  return Array.isArray(found) ? (found as readonly Settings[]) : [];
}

export interface BarrierOf<N> {
  name: string;
  kind: 'barrier' | 'collector';
  hits: N;
  rocks_hit?: N;
  passed_above: N;
  outcomes?: Record<string, N>;
  least_clearance_m: N | null;
  /// Missing if no rock hit it.
  statistics?: Record<string, FiguresOf<N>>;
  histograms?: Record<string, HistogramOf<N> | null>;
}

/// The terrain as a coarse grid of elevations, row by row from the south-west; null: no ground.
export interface Relief {
  x0: number;
  y0: number;
  cell_m: number;
  columns: number;
  rows: number;
  z_m: (number | null)[];
}

export interface TerrainSummary {
  kind?: string;
  /// Vertices of a section, x and z [m].
  section?: [number, number][];
  crs_wkt?: string;
  /// The lowest and the highest corner [m].
  bounds?: [number, number, number][];
  triangles?: number;
  relief?: Relief;
}

/// A percentile with the ends of its confidence interval; null if there are too few rocks.
export type IntervalOf<N> = [N, N | null, N | null];
/// A share with its confidence interval.
export interface ShareOf<N> {
  value: N;
  low: N;
  high: N;
}
/// What the check of a standard requires of a kit.
export interface NeedsOf<N> {
  energy_J: N;
  class: N;
  height_m: N;
}

/// The rocks that cross a line, or a section of it.
export interface CrossingOf<N> {
  rocks: N;
  share: ShareOf<N> | null;
  /// By quantity, then by percentile.
  percentiles: Record<string, Record<string, IntervalOf<N>>>;
  needs: NeedsOf<N> | null;
  needs_at_upper_end: NeedsOf<N> | null;
  clearance_m: N | null;
  most_elongation_m: N | null;
}
export interface DesignSectionOf<N> extends CrossingOf<N> {
  from_m: N;
  to_m: N;
}
export interface DesignLineOf<N> extends CrossingOf<N> {
  name: string;
  length_m: N;
  sections: DesignSectionOf<N>[];
}

/// A kit at a line.
export interface PairKitOf<N> {
  line: string;
  kit: string | null;
  height_m: N;
  energy_J: N;
}
export interface RankedKitOf<N> extends PairKitOf<N> {
  class: N | null;
  suffices: boolean;
  sure: boolean;
  limited_by: string | null;
  limit: string | null;
  caught_share: ShareOf<N> | null;
  above: N;
  through: N;
  beside: N;
  cost: N;
  needs_clearance_m: N | null;
  clearance_m: N | null;
  residual_height_m: N | null;
  below_residual_share: ShareOf<N> | null;
}
/// Two lines, one behind the other.
export interface DesignPairOf<N> {
  first: PairKitOf<N>;
  second: PairKitOf<N>;
  suffices: boolean;
  sure: boolean;
  caught_share: ShareOf<N> | null;
  caught_by_first: N;
  at_second: N;
  caught_by_second: N;
  beside: N;
  cost: N;
  overlap_m: N | null;
  distance_m: N | null;
  needs_overlap_m: N | null;
}
/// A factor of the check, with where its value is from.
export interface AppliedFactorOf<N> {
  symbol: string;
  key: string;
  multiplies: string;
  value: N;
  source: string;
  not_read: string;
}
export interface DesignOf<N> {
  standard: string | null;
  standard_not_read?: string;
  factors: {
    clearance_m: N;
    clears_half_the_block: boolean;
    of_total_energy: boolean;
    level: 'SEL' | 'MEL';
    block_mass_kg: N | null;
  };
  applied_factors?: AppliedFactorOf<N>[];
  confidence: N;
  design_percentile: N;
  catch_share: N;
  free_end_m: N;
  lines: DesignLineOf<N>[];
  best: RankedKitOf<N> | null;
  ranking: RankedKitOf<N>[];
  pairs?: DesignPairOf<N>[];
}

export interface SummaryOf<N> {
  name: string;
  seed: N;
  rocks: { planned: N; done: N; lifted: N };
  interrupted: boolean;
  end_reasons: Record<string, N>;
  events: N;
  statistics: Record<string, FiguresOf<N>>;
  histograms?: Record<string, HistogramOf<N> | null>;
  barriers?: BarrierOf<N>[];
  design?: DesignOf<N>;
  sources: { name: string }[];
  /// By seeder.
  releases?: { rocks: N }[];
  project: Project;
  /// Files with the checksums that they had when the run began, and where values of the library are from.
  inputs?: {
    files: { name: string; bytes: N; sha256: string }[];
    material_sources?: { material: string; like: string; keys: string[]; source: string }[];
    /// As a data URI.
    logo?: string;
  };
  talus?: { version: string };
  warnings: string[];
  /// Of the warnings that have one, by their place in the list.
  warning_kinds?: { warning: N; kind: string; where: string }[];
  notes?: string[];
  terrain?: TerrainSummary;
  energy_datum_m?: N;
  timings: { seconds: N; rocks_per_second: N; threads: N };
}
