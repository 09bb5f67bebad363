// Requests for observed rocks and for the results of calibrations.

import { getJson } from './client';
import type { Point2, Problem } from './types';

/// x, y, z of the ground, name, mass in kg.
export type ObservedPlace = [number, number, number | null, string, number | null];

export interface ByChance {
  value: number;
  median: number;
  p95: number;
  /// The share of draws that are as far by chance alone.
  p_value: number;
}
export interface LineFacts {
  mean: number;
  p05: number;
  median: number;
  p95: number;
  cumulative: Point2[];
}
export interface ObservedQuantity {
  key: 'position' | 'x' | 'runout' | 'lateral';
  energy_distance: ByChance;
  simulated?: LineFacts;
  observed?: LineFacts;
}
export interface ObservedComparison {
  file: string;
  rocks: number;
  draws: number;
  /// "from the mean release".
  runout: string | null;
  quantities: ObservedQuantity[];
  problems: Problem[];
}

/// A value and the ends of its range.
export type RangeOf = [number, number, number];
export interface FigureUncertainty {
  line: string;
  text: string;
  unit: string;
  ensembles: number;
  total: RangeOf;
  parameters: RangeOf;
  rocks: RangeOf;
  parameter_share: number;
}
export interface Uncertainty {
  ensembles: number;
  confidence: number;
  figures: FigureUncertainty[];
}

export interface Band {
  low: number[];
  median: number[];
  high: number[];
}
/// summary.json of a calibration. Without a posterior its figures are null or missing.
export interface CalibrationSummary {
  study: string;
  sets: number;
  rocks_per_set: number;
  agreeing_sets: number;
  effective_sets: number;
  misfit: number;
  best: { score: number; values: Record<string, number>; settings: Record<string, string[]> };
  parameters: {
    name: string;
    unit: string;
    prior: { p05: number; p50: number; p95: number };
    posterior: { p05: number; p25: number; p50: number; p75: number; p95: number } | null;
    width_of_prior: number;
    histogram: { edges: number[]; prior: number[]; posterior: number[] } | null;
  }[];
  /// A row for each parameter, with the parameters before it.
  correlations: number[][] | null;
  observations: {
    name: string;
    site: string;
    count: number;
    threshold: number;
    best_distance: number | null;
    zones?: { name: string; observed_share: number; predicted_share: { p05: number; p50: number; p95: number } }[];
    features: {
      name: string;
      unit: string;
      observed_mean: number;
      observed_std_dev: number | null;
      predicted_mean?: number;
      predicted_std_dev?: number;
      distribution?: { observed: number[]; at: number[]; prior: Band; posterior: Band };
    }[];
  }[];
  held_out: { name: string; observations: number; posterior: number; prior: number; constant: number | null }[];
  held_out_coverage?: { observations: string; name: string; count: number; within_90: number; expected: [number, number] }[];
  warnings: string[];
}

const file = (name: string) => `file=${encodeURIComponent(name)}`;
const at = (run: string) => `/api/runs/${encodeURIComponent(run)}`;

export const observing = {
  places: (model: string, name: string, signal?: AbortSignal) =>
    getJson<{ places: ObservedPlace[]; problems: Problem[] }>(`/api/models/${model}/observed?${file(name)}`, signal),
  compared: (run: string, name: string, signal?: AbortSignal) =>
    getJson<ObservedComparison>(`${at(run)}/observed?${file(name)}`, signal),
  uncertainty: (run: string, signal?: AbortSignal) => getJson<Uncertainty>(`${at(run)}/uncertainty`, signal),
  calibration: (run: string, signal?: AbortSignal) => getJson<CalibrationSummary>(`${at(run)}/summary`, signal),
};
