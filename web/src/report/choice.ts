// The selected rock of each run, shown in red.

import type { Rock } from './data';
import { runs } from './run';

interface Choice {
  /// By the place of the run on the page; null: the run has no trajectories.
  rocks: (Rock | null)[];
  /// Called after another choice.
  listeners: (() => void)[];
}
export const choice: Choice = { rocks: runs.map(({ rocks }) => rocks[0] ?? null), listeners: [] };

export function choose(rock: Rock) {
  choice.rocks[rock.run] = rock;
  for (const listener of choice.listeners) listener();
}
