// Asking a finished run in 2D what stays in a ditch or on a bench ("Ditches" in docs/workbench-api.md).

import { sendJson } from './client';
import type { Interval, Share } from './line';
import type { Problem } from './types';

export interface DitchShare {
  rocks: number;
  /// Null: of no rocks.
  share: Share | null;
}
/// Distances from the toe [m].
export interface Distances {
  rocks: number;
  /// By "50", "90", "95" and "99"; empty without rocks.
  percentiles: Record<string, Interval>;
  most: number | null;
  /// Values from here on are lower limits: a barrier stopped rocks there. Null: all are known.
  known_to_m: number | null;
}
export interface DitchAnswer {
  run: { rocks: number; stored: number };
  toe_m: number;
  far_m: number;
  width_m: number;
  confidence: number;
  /// Of the stored rocks those that are released before the toe, and the others.
  rocks: number;
  released_beyond: number;
  /// Of all of them.
  arriving: DitchShare;
  inside: DitchShare;
  beyond: DitchShare;
  /// Kept from the far edge by a barrier before it; and these with those that get beyond.
  held: DitchShare;
  beyond_or_held: DitchShare;
  kept: DitchShare;
  /// Of those that get past the toe.
  retained: DitchShare;
  impact: Distances;
  rollout: Distances;
  slope: { height_m: number; angle_deg: number } | null;
  criteria: { name: string; source: string; width_m: number | null; text: string }[];
  problems: Problem[];
}

export const askDitch = (run: string, toe_m: number, far_m: number, signal?: AbortSignal) =>
  sendJson<DitchAnswer>('POST', `/api/runs/${encodeURIComponent(run)}/ditch`, { toe_m, far_m }, signal);
