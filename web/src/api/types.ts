// Responses of the server: docs/workbench-api.md.

import type { WordOf } from '../settings/names';

export interface About {
  version: string;
  folder: string;
  /// Identifies the folder.
  workplace: string;
  project: string | null;
  limits: { upload_bytes: number; project_bytes: number };
}

/// Problems that are told from others; empty: none of these.
export type ProblemKind = '' | 'mostly_on_ground' | 'height_below_block' | 'kit_below_block' | 'beyond_ends' | 'models_disagree';
export interface Problem {
  severity: 'warning' | 'error';
  kind: ProblemKind;
  file: string;
  line: number;
  path: string;
  where: string;
  what: string;
  why: string;
  hint: string;
  text: string;
}

export interface Example {
  id: string;
  title: string;
  what: string;
  file: string;
}

export interface LibrarySource {
  /// The values that are from it.
  keys: string[];
  text: string;
  /// For which rocks and which model its numbers hold.
  limits: string;
  checked: string;
}
export interface LibraryMaterial {
  key: string;
  name: string;
  values: Record<string, unknown>;
  sources: LibrarySource[];
}

export type FileKind = 'project' | 'study' | 'materials' | 'raster' | 'picture' | 'mesh' | 'points' | 'vector' | 'other';
export interface FolderFile {
  name: string;
  bytes: number;
  modified: string;
  kind: FileKind;
  /// Of a project: when its picture was saved [ms since 1970]; null: it has none.
  picture?: number | null;
}
export interface DeletedProject {
  id: string;
  /// Its name before.
  file: string;
  deleted: string;
  /// The number of its runs.
  runs: number;
}

export interface Draft {
  text: string;
  /// The hash of the file that the draft is based on; null if there was none.
  saved: string | null;
}
/// A draft on the server, with the last revision of each tab that contributed to it, the most recent last.
export interface KeptDraft extends Draft {
  revisions: string[];
}
/// The revision of a draft, and that of the server's draft it is based on (null: none).
export interface Revision {
  revision: string;
  after: string | null;
}
export interface ProjectText extends Draft {
  file: string;
  draft: KeptDraft | null;
}

export type Point2 = [number, number];
export type Point3 = [number, number, number];

export interface ModelSeeder {
  name: string;
  type: WordOf<'seeder', 'type'>;
  /// The path of the entry in the project, such as "seeder.0".
  path: string;
  rocks: number;
  first_rock: number;
  lines: Point3[][];
  points: Point3[];
}

export interface ModelArea {
  name: string;
  path: string;
  /// Index into the model's materials.
  material: number;
  sides: Point3[][];
}

/// A forest that is drawn on plan.
export interface ModelForest {
  name: string;
  path: string;
  sides: Point3[][];
}

export interface ModelBarrier {
  name: string;
  kind: 'barrier' | 'collector';
  path: string;
  height_m: number;
  capacity_kJ: number | null;
  foot: Point3[];
  top: Point3[];
}

export interface Model {
  id: string;
  /// Changes when a file that was read changes.
  files: string;
  dimension: 2 | 3;
  kind: 'section' | 'mesh' | 'raster';
  rocks: number;
  crs: string;
  facets: number;
  bounds: { min: Point3; max: Point3 };
  terrain_report: string;
  seeder_report: string;
  materials: string[];
  areas: ModelArea[];
  forests: ModelForest[];
  seeders: ModelSeeder[];
  barriers: ModelBarrier[];
  project: Record<string, unknown>;
}

export interface ModelAnswer {
  problems: Problem[];
  model: Model | null;
}

export interface PolygonsAnswer {
  vertices: Point3[];
  triangles: [number, number, number][];
  report: string;
  problems: Problem[];
}

/// The ground along a line on plan, point by point.
export interface GroundSection {
  distance_m: number[];
  /// Null: no terrain up to the next point.
  z_m: (number | null)[];
  x_m: number[];
  y_m: number[];
  /// The index of the ground's material from each point to the next; null: no ground, or a step.
  materials: (number | null)[];
}

export interface Tiles {
  origin: Point3;
  cell: Point2;
  columns: number;
  rows: number;
  tile: number;
  levels: { stride: number; columns: number; rows: number }[];
}

export type RunState = 'waiting' | 'running' | 'done' | 'stopped' | 'interrupted' | 'failed';
export interface Run {
  id: string;
  name: string;
  /// Of a calibration, rocks, done and rate count sets of parameters.
  kind: 'run' | 'calibration';
  /// The study file of a calibration, beside the project.
  study: string | null;
  file: string;
  project: string;
  state: RunState;
  dimension: 2 | 3;
  rocks: number;
  done: number;
  rate: number | null;
  seconds: number;
  seconds_left: number | null;
  has_results: boolean;
  begun: string;
  problems: Problem[];
  folder: string;
}

export interface Statistics {
  unit: string;
  count: number;
  /// Given if the table of end points has a sample of the rocks.
  sample: { rocks: number; of: number } | null;
  statistics: Record<string, number>;
  histogram: { edges: number[]; counts: number[] };
  cumulative: Point2[];
  box: {
    least: number;
    whisker_low: number;
    q1: number;
    median: number;
    q3: number;
    whisker_high: number;
    most: number;
  };
}

export interface RockAnswer {
  endpoint: Record<string, string>;
  columns: string[];
  rows: string[][];
  hits: Record<string, string>[];
  energy: [number, number, number, number][];
}

export interface RunMap {
  name: string;
  meaning: string;
  unit: string;
  /// The range of the values above 0.
  least: number;
  most: number;
  source: string | null;
}

export interface Difference {
  key: string;
  here: unknown;
  there: unknown;
}

export interface Verification {
  passes: boolean;
  cases: VerificationCase[];
}

export interface VerificationCase {
  case: string;
  title: string;
  passes: boolean;
  seconds: number;
  agree: number;
  compared: number;
  tables: {
    title: string;
    source: string;
    run: string;
    why: string;
    agree: number;
    differ: number;
    numbers: {
      row: string;
      quantity: string;
      published: string;
      talus: number;
      difference: number;
      allowed: string;
      verdict: string;
    }[];
  }[];
}
