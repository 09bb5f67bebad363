// What the colours of paths mean: a quantity along them on a scale, or a kind of rock by its name.

import { computed } from '@preact/signals';
import { categoryColour, pathRamp, type Ramp } from '../view/colours';
import { pathColour, type PathColour } from '../view/settings';
import { runColour, shade } from '../view/theme';
import { roundUp } from '../view/ticks';
import { comparedPaths, shownPaths, type DrawnPaths } from './drawnPaths';

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
  values: Float32Array; // one a point; NaN: not known
  low: number;
  high: number;
  /// Some values are greater than `high`: they have its colour.
  isClipped: boolean;
  ramp: Ramp;
}
export interface KindsColouring {
  kind: 'kinds';
  by: 'source' | 'seeder' | 'reason';
  title: string;
  /// One a rock: its place in `names`.
  numbers: Uint8Array | Uint16Array;
  names: string[];
  colours: string[];
  /// Whether any rock that is drawn is of the kind; others need no line in a legend.
  isThere: boolean[];
}
/// One colour for all: that of its run, where two are compared.
export interface RunColouring {
  kind: 'run';
  colour: string;
}
export type Colouring = ScaleColouring | KindsColouring | RunColouring;

/// What all but a few of the values stay below. A single fast rock would leave the others one colour.
function topOf(values: Float32Array): { high: number; isClipped: boolean } {
  let [most, count] = [0, 0];
  for (const value of values) {
    if (value > most) most = value;
    if (value >= 0) ++count;
  }
  if (most === 0) return { high: 1, isClipped: false };
  const bins = new Uint32Array(1000);
  for (const value of values) if (value >= 0) bins[Math.min(999, Math.floor((1000 * value) / most))]!++;
  let above = 0;
  let bin = 999;
  while (bin > 0 && (above += bins[bin]!) <= 0.005 * count) --bin;
  const high = roundUp((most * (bin + 1)) / 1000);
  return { high, isClipped: high < most };
}

const tops = new WeakMap<Float32Array, ReturnType<typeof topOf>>();

function scale(paths: DrawnPaths, by: ScaleColouring['by']): ScaleColouring {
  const [values, unit] = {
    speed: [paths.speeds, 'm/s'] as const,
    energy: [paths.energies, 'kJ'] as const,
    height: [paths.heights, 'm'] as const,
  }[by];
  const top = tops.get(values) ?? topOf(values);
  tops.set(values, top);
  return { kind: 'scale', by, title: `${pathColours[by]}, ${unit}`, values, low: 0, ...top, ramp: pathRamp[shade.value] };
}

function kinds({ header, sources, seeders, reasons }: DrawnPaths, by: KindsColouring['by']): KindsColouring {
  const [numbers, names] = {
    source: [sources, header.sources] as const,
    seeder: [seeders, header.seeders] as const,
    reason: [reasons, header.reasons] as const,
  }[by];
  const isThere = names.map(() => false);
  for (const number of numbers) isThere[number] = true;
  return { kind: 'kinds', by, title: pathColours[by], numbers, names, colours: names.map((_, k) => categoryColour(k)), isThere };
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

/// Of the run that is shown.
export const colouring = computed<Colouring | null>(() =>
  shownPaths.value ? colouringOf(shownPaths.value, pathColour.value) : null,
);
