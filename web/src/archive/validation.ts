// The data of the page of a field experiment (src/talus/calibration/validation_page.cpp).

import type { Band } from './calibration';

/// Runouts [m]: observed, and quantiles of those predicted from the run's own release.
export interface PredictedRun {
  name: string;
  observed: number;
  p05: number;
  p25: number;
  p75: number;
  p95: number;
}

type Place = [x: number, y: number];
/// Places on plan [m]; of the predicted stops some.
export interface PredictedPlan {
  releases: Place[];
  observed: Place[];
  predicted: Place[];
}

/// A row of results.csv. Runouts are on plan [m].
export interface Result {
  model: string;
  predicted: string;
  runs: number;
  in_50: number;
  in_90: number;
  observed_mean_m: number;
  observed_std_dev_m: number;
  mean_m: number;
  mean_p05_m: number;
  mean_p95_m: number;
  std_dev_m: number;
  std_dev_p05_m: number;
  std_dev_p95_m: number;
  in_50_least: number;
  in_50_most: number;
  in_90_least: number;
  in_90_most: number;
  crps_m: number;
  crps_prior_m: number;
  crps_constant_m: number;
  place_m: number;
  place_prior_m: number;
  place_constant_m: number;
  rmse_m: number;
  rmse_constant_m: number;
  mae_m: number;
  mae_constant_m: number;
}
/// A row of groups.csv.
export interface GroupResult {
  model: string;
  group: string;
  runs: number;
  observed_mean_m: number;
  mean_m: number;
  rmse_m: number;
  rmse_constant_m: number;
}
export interface Published {
  name: string;
  observed_mean_m: number;
  predicted_mean_m: number;
  mean_abs_error_m: number | null;
  source: string;
}
export interface Prediction {
  model: string;
  site: string;
  from: string;
  /// Mean runout of the runs that were calibrated on [m].
  mean_of_the_others: number;
  runs: PredictedRun[];
  distribution: { observed: number[]; at: number[]; posterior: Band };
  plan: PredictedPlan;
  parameters: { name: string; unit: string; prior: { p05: number; p95: number }; posterior: { p05: number; p50: number; p95: number } }[];
  warnings: string[];
}
export interface Experiment {
  talus: string;
  title: string;
  summary: string;
  limits: string[];
  results: Result[];
  groups: GroupResult[];
  published: Published[];
  predictions: Prediction[];
  split: string;
  sought: string[];
  not_sought: string[];
  citations: string[];
  licence: string;
}
