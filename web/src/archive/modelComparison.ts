// compare.json of `talus compare --models` (app/cli/compare.cpp): the figures of each rock model.

import type { IntervalOf } from './summary';

export type ModelFigure =
  | 'share'
  | 'ke_translational_J'
  | 'ke_total_J'
  | 'height_m'
  | 'velocity_m_s'
  | 'runout_median_m'
  | 'runout_m'
  | 'left';
/// Null: no rock is there.
export type ModelFigures = Record<ModelFigure, IntervalOf<number> | null>;

export interface ModelVariation extends ModelFigures {
  model: string;
  changes: { path: [table: string, row: number, key: string]; after: unknown }[];
}

/// Horizontal distance and elevation [m].
export type SidePlace = readonly [number, number];
/// Paths as seen from the side, the same view for all models.
export interface SideView {
  is_section: boolean;
  /// Null: no ground up to the next place.
  ground: readonly (SidePlace | null)[];
  sets: readonly { model: string; paths: readonly (readonly SidePlace[])[]; runout_m: readonly number[] }[];
}

export interface ModelComparison {
  name: string;
  talus: { version: string };
  project: string;
  seed: number;
  /// Empty: nowhere, so that only runout is compared.
  place: string;
  is_line: boolean;
  /// Sentences about figures by which the models differ more than by chance.
  disagreements: string[];
  warnings: string[];
  rocks: number;
  percentile: number;
  confidence: number;
  /// The project's own.
  model: string;
  base: ModelFigures;
  variations: ModelVariation[];
  /// Null: no paths were kept.
  side_view: SideView | null;
}
