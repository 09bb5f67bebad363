// summary.json of a sensitivity study (src/talus/sensitivity/output.cpp). Estimates have the ends of their confidence
// intervals.

import type { IntervalOf } from './summary';

export interface SensitivityInput {
  /// Of the last input, the seed, by which the rocks differ, it is the noise of their finite number.
  name: string;
  unit: string;
  values: string;
}

/// Of Morris screening.
export interface ElementaryEffect {
  effect: IntervalOf<number>;
  mean_effect: number;
  spread: number;
}
/// Of Sobol's method.
export interface SobolIndices {
  total: IntervalOf<number>;
  first: IntervalOf<number>;
}

/// Without a known effect.
export interface NoEffect {
  effect?: undefined;
  total?: undefined;
}

export interface SensitivityResult {
  title: string;
  unit: string;
  /// Those in which it has a value.
  runs: number;
  mean: number | null;
  least: number | null;
  most: number | null;
  /// In the order of the inputs.
  inputs: (ElementaryEffect | SobolIndices | NoEffect)[];
}

export interface SensitivitySummary {
  talus: { version: string };
  name: string;
  sites: { name: string; project: string }[];
  method: 'morris' | 'sobol';
  seed: number;
  rocks: number;
  runs: number;
  confidence: number;
  inputs: SensitivityInput[];
  results: SensitivityResult[];
  warnings: string[];
}
