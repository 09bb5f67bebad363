// The colouring of trajectories: by a quantity along them on a scale, or by a category of the rock.

import { computed } from '@preact/signals';
import { categoryColour, pathRamp, type Ramp } from '../view/colours';
import { keptOfProject } from '../project/ofProject';
import { runColour, shade } from '../view/theme';
import { displayOf } from '../state/displayUnits';
import { owned } from '../state/owned';
import { roundUp } from '../geometry/ticks';
import { comparedPaths, shownPaths, type DrawnPaths } from './drawnPaths';

export type PathColour = 'speed' | 'energy' | 'height' | 'source' | 'seeder' | 'reason';
export const [pathColour, colourBy] = owned(keptOfProject<PathColour>('path colour', 'speed'));

export const pathColours: Record<PathColour, string> = {
  speed: 'Speed',
  energy: 'Total kinetic energy',
  height: 'Height above ground',
  source: 'Source',
  seeder: 'Seeder',
  reason: 'End reason',
};

export interface ScaleColouring {
  kind: 'scale';
  by: 'speed' | 'energy' | 'height';
  title: string; // with the unit
  values: Float32Array; // one per point, in metric units; NaN: unknown
  low: number;
  high: number;
  /// Values are divided by this for display.
  per: number;
  /// Whether values above `high` are drawn in its colour.
  isClipped: boolean;
  ramp: Ramp;
}
export interface KindsColouring {
  kind: 'kinds';
  by: 'source' | 'seeder' | 'reason';
  title: string;
  /// For each rock the index into `names`.
  numbers: Uint8Array | Uint16Array;
  names: string[];
  colours: string[];
  /// Whether any drawn rock is of the kind; the legend omits the others.
  isUsed: boolean[];
}
/// One colour per run while two runs are compared.
export interface RunColouring {
  kind: 'run';
  colour: string;
}
export type Colouring = ScaleColouring | KindsColouring | RunColouring;

/// The upper end of the scale, above all but 0.5 % of the values: a single fast rock would leave the others one colour.
function topOf(values: Float32Array): { high: number; isClipped: boolean } {
  let [maximum, count] = [0, 0];
  for (const value of values) {
    if (value > maximum) maximum = value;
    if (value >= 0) ++count;
  }
  if (maximum === 0) return { high: 1, isClipped: false };
  const bins = new Uint32Array(1000);
  for (const value of values) if (value >= 0) bins[Math.min(999, Math.floor((1000 * value) / maximum))]!++;
  let above = 0;
  let bin = 999;
  while (bin > 0 && (above += bins[bin]!) <= 0.005 * count) --bin;
  const high = roundUp((maximum * (bin + 1)) / 1000);
  return { high, isClipped: high < maximum };
}

const tops = new WeakMap<Float32Array, ReturnType<typeof topOf>>();

function scale(paths: DrawnPaths, by: ScaleColouring['by']): ScaleColouring {
  const [values, metric] = {
    speed: [paths.speeds, 'm/s'] as const,
    energy: [paths.energies, 'kJ'] as const,
    height: [paths.heights, 'm'] as const,
  }[by];
  const { unit, per } = displayOf(metric);
  const top = tops.get(values) ?? topOf(values);
  tops.set(values, top);
  return { kind: 'scale', by, title: `${pathColours[by]}, ${unit}`, values, low: 0, ...top, per, ramp: pathRamp[shade.value] };
}

function kinds({ header, sources, seeders, reasons }: DrawnPaths, by: KindsColouring['by']): KindsColouring {
  const [numbers, names] = {
    source: [sources, header.sources] as const,
    seeder: [seeders, header.seeders] as const,
    reason: [reasons, header.reasons] as const,
  }[by];
  const isUsed = names.map(() => false);
  for (const number of numbers) isUsed[number] = true;
  return { kind: 'kinds', by, title: pathColours[by], numbers, names, colours: names.map((_, k) => categoryColour(k)), isUsed };
}

function colouringOf(paths: DrawnPaths, by: PathColour): Colouring {
  if (comparedPaths.value) return { kind: 'run', colour: runColour('shown') };
  switch (by) {
    case 'speed':
    case 'energy':
    case 'height':
      return scale(paths, by);
    default:
      return kinds(paths, by);
  }
}

/// The colouring of the shown run.
export const colouring = computed<Colouring | null>(() =>
  shownPaths.value ? colouringOf(shownPaths.value, pathColour.value) : null,
);
