// Asking a line or a polygon which rocks cross it: requests to a run that is finished ("Ask a line" in
// docs/workbench-api.md).

import { getArrays, sendJson } from './client';
import type { AppliedFactorOf } from '../archive/summary';
import type { Point2, Point3, Problem } from './types';

/// A value with the ends of its confidence interval; null: too few rocks.
export type Interval = [number, number | null, number | null];
export interface Share {
  value: number;
  low: number;
  high: number;
}

/// A value of all rocks, and the range in which most ensembles are.
export type EnsembleRange = [number, number, number];
/// Of a run with uncertain parameters. Null: rocks of too few ensembles cross or enter.
type EnsembleSpread<More extends string> = { ensembles: number; crossing: number; confidence: number } & Record<'share' | LineQuantity | More, EnsembleRange | null>;

export type LineQuantity = 'ke_translational_J' | 'ke_total_J' | 'velocity_m_s' | 'height_m';
export interface Needs {
  energy_J: number;
  /// By the standard; without one it means nothing.
  class: number;
  height_m: number;
}

/// The figures of a line or of a section of it, as those of a design.
export interface LineFigures {
  from_m: number;
  to_m: number;
  rocks: number;
  /// Null: no rock was asked.
  share: Share | null;
  /// By quantity and percentile ("95"); empty if no rock crosses.
  percentiles: Partial<Record<LineQuantity, Record<string, Interval>>>;
  needs: Needs | null;
  needs_at_upper_end: Needs | null;
  maxima: Record<LineQuantity, number> | null;
  /// The diameter of the largest rock that crosses; null: none does.
  largest_block_m: number | null;
}

/// What each kit would stop, by height and by energy; shares are null if no rock crosses.
export interface KitTable {
  heights_m: number[];
  energies_kJ: number[];
  stopped: number[][];
  share: (number | null)[][];
  low: (number | null)[][];
  high: (number | null)[][];
}

/// Whether the intervals are narrow, and how many rocks of the run would make them so.
export interface Enough {
  /// Null: unknown.
  rocks: number | null;
  /// Empty if there are enough.
  text: string;
}

/// Texts to print, rounded by the engine; empty if no rock crosses.
export type CardKey = 'share' | 'energy' | 'height' | 'velocity';
export type CardTexts = Record<CardKey | `${CardKey}_interval`, string> & { needs: string; needs_at_upper_end: string };

/// By release place from which rocks cross.
export interface SourceShares {
  release: number[];
  rocks: number[];
  crossing: number[];
  clearing?: number[];
  stopping?: number[];
  share: number[];
  low: number[];
  high: number[];
}

type AppliedFactor = AppliedFactorOf<number>;

interface AnyAnswer {
  run: { rocks: number; stored: number };
  enough: Enough;
  sources?: SourceShares;
  selection: string;
  crossing_rocks: number[];
  problems: Problem[];
}
export interface LineAnswer extends AnyAnswer {
  kind: 'line' | 'barrier' | 'collector';
  length_m: number;
  from_m: number;
  foot: Point3[];
  standard: string | null;
  applied_factors: AppliedFactor[];
  /// Of the check; without a standard they change nothing. `block_mass_kg`: of a design block, whose mass takes the place of
  /// those of the rocks.
  factors: { of_total_energy: boolean; level: 'MEL' | 'SEL'; block_mass_kg: number | null };
  design_percentile: number;
  confidence: number;
  whole: LineFigures;
  sections: LineFigures[];
  worst: { section: number; from_m: number; to_m: number } | null;
  kits: KitTable;
  /// The kit of the question, in words; null without one.
  kit: { text: string } | null;
  card: CardTexts;
  /// Null: all rocks have the same parameters.
  ensembles: EnsembleSpread<'needs_energy_J' | 'needs_class' | 'needs_height_m'> | null;
}
export interface PolygonAnswer extends AnyAnswer {
  kind: 'polygon';
  area_m2: number;
  /// z is null off the terrain.
  outline: [number, number, number | null][];
  confidence: number;
  entering: { rocks: number; share: Share | null };
  stopping: { rocks: number; share: Share | null };
  percentiles: LineFigures['percentiles'];
  maxima: LineFigures['maxima'];
  ensembles: EnsembleSpread<'stopping'> | null;
}
export type AskedAnswer = LineAnswer | PolygonAnswer;

/// Null: the line is refused, for example because it is off the terrain.
export interface StationAnswer {
  length_m: number | null;
  whole: LineFigures | null;
}

export interface AskedShape {
  line?: Point2[];
  barrier?: string;
  polygon?: Point2[];
}
export interface Question extends AskedShape {
  height_m?: number;
  energy_kJ?: number;
  sources?: boolean;
  drag?: { id: string; number: number };
}

/// Where rocks start.
export interface Releases {
  header: { origin: Point3; seeders: string[]; sources: string[]; places: number };
  firstRocks: Uint32Array;
  rocks: Uint32Array;
  positions: Float32Array; // three per place, relative to the origin [m]
  sizes: Float32Array; // dx, dy of a cell; 0, 0: not a cell [m]
  seeders: Uint16Array;
}

const at = (run: string) => `/api/runs/${encodeURIComponent(run)}`;

export const asking = {
  ask: (run: string, question: Question, signal?: AbortSignal) =>
    sendJson<AskedAnswer>('POST', `${at(run)}/line`, question, signal),
  /// Several lines at once, without sections, kits and sources.
  stations: async (run: string, lines: Point2[][], signal?: AbortSignal) =>
    (await sendJson<{ lines: StationAnswer[] }>('POST', `${at(run)}/line`, { lines, sources: false }, signal)).lines,
  releases: async (run: string, signal?: AbortSignal): Promise<Releases> => {
    const { header, arrays } = await getArrays<Releases['header']>(`${at(run)}/releases`, signal);
    const { first_rocks: firstRocks, ...others } = arrays;
    return { header, firstRocks, ...others } as Releases;
  },
};
