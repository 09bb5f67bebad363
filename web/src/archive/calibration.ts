// summary.json of a calibration (src/talus/calibration/result_summary.cpp). Without a posterior its figures are null or
// missing.

/// Quantiles of a distribution function: 5, 50 and 95 % at each place.
export interface Band {
  low: number[];
  median: number[];
  high: number[];
}
/// Quantiles of a share.
export interface ShareRange {
  p05: number;
  p50: number;
  p95: number;
}

export interface CalibratedParameter {
  /// Its path in the project: "material.Scree.roughness_deg", or with "@SITE" if each site has its own.
  name: string;
  unit: string;
  prior: { p05: number; p50: number; p95: number };
  posterior: { p05: number; p25: number; p50: number; p75: number; p95: number } | null;
  width_of_prior: number;
  learned_nothing?: boolean;
  histogram: { edges: number[]; prior: number[]; posterior: number[] } | null;
}

export interface CalibratedFeature {
  name: string;
  unit: string;
  observed_mean: number;
  observed_std_dev: number | null;
  predicted_mean?: number;
  predicted_std_dev?: number;
  /// `at` is empty if no set has a simulated rock of this group.
  distribution?: { observed: number[]; at: number[]; prior: Band; posterior: Band };
}

export interface CalibratedZone {
  name: string;
  /// null: only shares are known.
  observed_amount?: number | null;
  observed_share: number;
  predicted_share: ShareRange;
  prior_share?: ShareRange;
}

export interface CalibratedGroup {
  name: string;
  site: string;
  count: number;
  threshold: number;
  best_distance: number | null;
  /// What the distance is: "energy distance" or "mean energy score".
  distance?: string;
  features: CalibratedFeature[];
  zones?: CalibratedZone[];
  deposits?: {
    unit: string;
    in_zones: number | null;
    released: number | null;
    elsewhere_observed: boolean;
    independent_rocks: number;
  };
}

/// Observations that were predicted from the others. Scores are over the observed spread.
export interface HeldOut {
  name: string;
  observations: number;
  posterior: number;
  prior: number;
  constant: number | null;
  features?: {
    observations: string;
    name: string;
    unit: string;
    observed_mean: number;
    observed_std_dev: number;
    predicted_mean: number;
    predicted_std_dev: number;
  }[];
}

export interface CalibrationSummary {
  talus?: string;
  study: string;
  seed?: number;
  sets: number;
  rocks_per_set: number;
  agreeing_sets: number;
  effective_sets: number;
  misfit: number;
  best: { score: number; values: Record<string, number>; settings: Record<string, string[]>; note?: string };
  parameters: CalibratedParameter[];
  /// A row for each parameter, with the parameters before it.
  correlations: number[][] | null;
  observations: CalibratedGroup[];
  held_out: HeldOut[];
  held_out_coverage?: { observations: string; name: string; count: number; within_90: number; expected: [number, number] }[];
  warnings: string[];
}
