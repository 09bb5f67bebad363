// Requests for observed rocks and for the results of calibrations.

import type { CalibrationSummary } from '../archive/calibration';
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
