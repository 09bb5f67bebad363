// How figures of a run develop with its rocks, and how they differ between its ensembles of parameters
// (src/talus/report/report.cpp, uncertainty_json.cpp).

/// A figure of the whole run, or at a line.
export interface NamedFigure {
  /// Empty: of the whole run.
  line: string;
  text: string;
  /// Empty: a share.
  unit: string;
}
export const figureTitle = ({ text, line }: NamedFigure) =>
  text.charAt(0).toUpperCase() + text.slice(1) + (line ? `: ${line}` : '');

/// Number of rocks, value, and the ends of its interval.
export type ConvergenceStep = [number, number, number | null, number | null];
export interface FigureConvergence extends NamedFigure {
  steps: ConvergenceStep[];
  rocks_needed: number | null;
}
export interface Convergence {
  confidence: number;
  tolerance: number;
  figures: FigureConvergence[];
}

/// A value and the ends of its range.
export type RangeOf = [number, number, number];
export interface FigureUncertainty extends NamedFigure {
  ensembles: number;
  total: RangeOf;
  parameters: RangeOf;
  rocks: RangeOf;
  /// Of the variance between ensembles.
  parameter_share: number;
}
export interface Uncertainty {
  ensembles: number;
  confidence: number;
  figures: FigureUncertainty[];
}
