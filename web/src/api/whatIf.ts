// What if: the rocks of a run with other values, in the background ("What if" in docs/workbench-api.md).

import { getJson, sendJson } from './client';
import type { AskedShape, Interval, Needs } from './line';
import type { Problem } from './types';

/// The factor of the variations with another rock model.
export const modelFactor = 'model';

/// A figure at the line; energies are those that the check takes.
export type WhatIfFigure = 'share' | 'energy_J' | 'height_m' | 'velocity_m_s';
/// Null: no rock crosses.
export type Figures = {
  rocks: number;
  /// Of a line: the fence that the check asks for, with all its factors.
  needs: Needs | null;
  /// From the upper ends of the intervals of sampling; null: too few rocks cross.
  needs_at_upper_end: Needs | null;
} & Record<WhatIfFigure | 'ke_translational_J' | 'ke_total_J', Interval | null>;

/// A value before and after, as in the project's file; null: the key is not given.
export interface Change {
  path: [table: string, row: number, key: string];
  name: string;
  before: unknown;
  after: unknown;
}
export interface Variation extends Figures {
  /// "model": the same rocks with another rock model.
  factor: string;
  title: string;
  /// Null: another model.
  step_percent: number | null;
  /// Of another model.
  model?: string;
  /// Of another model: the shapes of its blocks; empty for models without.
  shapes?: string[];
  /// The values before and after, for people.
  text: string;
  /// Which values ended at the limit of their range.
  clipped: string;
  changes: Change[];
  difference: { gained: number; lost: number } & Record<WhatIfFigure, Interval | null>;
}
export interface WhatIfAnswer {
  /// Of each set; of the run.
  rocks: number;
  planned: number;
  percentile: number;
  confidence: number;
  energy: 'total' | 'translational';
  /// Whose factors are in `needs`.
  standard: string | null;
  /// The project's own.
  model: string;
  base: Figures;
  /// In which figures another model differs from the project's own by more than chance.
  models_disagree: { model: string; figure: string }[];
  variations: Variation[];
}
export interface WhatIfFactor {
  factor: string;
  title: string;
  usual_percent: number;
}
/// What can be varied of a run; of one material, if it was asked for.
export interface WhatIfChoices {
  materials: string[];
  factors: WhatIfFactor[];
}
/// Without steps: the usual ones of all factors. What is not a number is refused.
export interface WhatIfOptions {
  material?: string;
  steps?: Record<string, unknown>;
  /// The other rock models, too.
  models?: boolean;
  /// Time for the runs; 40 unless given, at most 600.
  seconds?: number;
}
export interface WhatIfState {
  run: string;
  question: AskedShape & WhatIfOptions;
  /// Of the run's request.
  overrides: { rocks: number | null; seed: number | null };
  state: 'running' | 'done' | 'stopped' | 'failed';
  done: number;
  planned: number;
  seconds: number;
  seconds_left: number | null;
  problems: Problem[];
  answer: WhatIfAnswer | null;
}

const at = (run: string) => `/api/runs/${encodeURIComponent(run)}/what_if`;

export const whatIfs = {
  begin: (run: string, asked: AskedShape & WhatIfOptions) => sendJson<WhatIfState>('POST', at(run), asked),
  /// Of the run's last one; null: there is none.
  state: (run: string) => getJson<WhatIfState | null>(at(run)),
  choices: (run: string, material: string, signal: AbortSignal) =>
    getJson<WhatIfChoices>(`${at(run)}/choices?material=${encodeURIComponent(material)}`, signal),
  stop: (run: string) => sendJson<WhatIfState>('POST', `${at(run)}/stop`, {}),
};
