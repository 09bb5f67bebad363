// Requests for observed rocks and for the results of calibrations.

import type { CalibrationSummary } from '../archive/calibration';
import type { ObservedComparison } from '../archive/observed';
import type { Uncertainty } from '../archive/uncertainty';
import { getJson } from './client';
import type { Problem } from './types';

/// x, y, z of the ground, name, mass in kg.
export type ObservedPlace = [number, number, number | null, string, number | null];

const file = (name: string) => `file=${encodeURIComponent(name)}`;
const at = (run: string) => `/api/runs/${encodeURIComponent(run)}`;

export const observing = {
  places: (model: string, name: string, signal?: AbortSignal) =>
    getJson<{ places: ObservedPlace[]; problems: Problem[] }>(`/api/models/${model}/observed?${file(name)}`, signal),
  compared: (run: string, name: string, signal?: AbortSignal) =>
    getJson<ObservedComparison & { problems: Problem[] }>(`${at(run)}/observed?${file(name)}`, signal),
  uncertainty: (run: string, signal?: AbortSignal) => getJson<Uncertainty>(`${at(run)}/uncertainty`, signal),
  calibration: (run: string, signal?: AbortSignal) => getJson<CalibrationSummary>(`${at(run)}/summary`, signal),
};
