// Where the rocks that cross come from: the release places of the run, with the share of their rocks that crosses the
// line, or would clear the kit.

import { computed, effect, signal } from '@preact/signals';
import { asking, type Releases, type SourceShares } from '../api/line';
import type { Point3, Run } from '../api/types';
import { reportFailure } from '../state/messages';
import { dimension } from '../project/place';
import { filter, filterBy } from '../runs/filter';
import { hasResults, shown } from '../runs/runs';
import { stopsOf, type LegendData } from '../view/legends';
import { shareRamp } from '../view/colours';
import { shade } from '../view/theme';
import { counted } from '../units/numbers';
import { roundUp } from '../geometry/ticks';
import { answer, isAsking, sourceColour, type SourceColour } from './asked';
import { percentText } from './kit';

/// The release places of the shown run; null while unknown.
export const releases = signal<Releases | null>(null);
let loaded = '';
let controller: AbortController | undefined;

async function load(run: Run, signal: AbortSignal) {
  try {
    const found = await asking.releases(run.id, signal);
    if (!signal.aborted) releases.value = found;
  } catch (error) {
    if (!signal.aborted) reportFailure(error, 'release places');
  }
}
effect(() => {
  const run = shown.value && hasResults(shown.value) && isAsking.value && answer.value ? shown.value : null;
  const key = run ? `${run.id} ${run.done}` : '';
  if (key === loaded || (run === null && loaded.startsWith(`${shown.value?.id} `))) return;
  loaded = key;
  controller?.abort();
  releases.value = null;
  if (run) void load(run, (controller = new AbortController()).signal);
});

/// A release place as the list and the scene show it.
export interface SourcePlace {
  number: number;
  name: string;
  /// "x 12.3, y 45.6 m"
  where: string;
  rocks: number;
  /// Of its stored rocks: those that cross, or would clear the kit.
  count: number;
  share: number;
  low: number;
  high: number;
}

const nameOf = ({ header, seeders }: Releases, number: number) => header.seeders[seeders[number]!] ?? '';

/// In the coordinates of the model, as all places on the page.
function whereText({ header: { origin }, positions }: Releases, number: number): string {
  const [x, y] = [0, 1].map((axis) => (origin[axis]! + positions[3 * number + axis]!).toFixed(1));
  return dimension.peek() === 2 ? `x ${x} m` : `x ${x}, y ${y} m`;
}

export function placesOf(sources: SourceShares, all: Releases): SourcePlace[] {
  const counts = sources.clearing ?? sources.crossing;
  return sources.release.map((number, k) => ({
    number,
    name: nameOf(all, number),
    where: whereText(all, number),
    rocks: sources.rocks[k]!,
    count: counts[k]!,
    share: sources.share[k]!,
    low: sources.low[k]!,
    high: sources.high[k]!,
  }));
}

/// The places from which rocks cross, the largest share first; null while unknown.
export const sourcePlaces = computed<SourcePlace[] | null>(() => {
  const [found, all] = [answer.value, releases.value];
  if (!found?.sources || !all) return null;
  return placesOf(found.sources, all).toSorted((a, b) => b.share - a.share || b.count - a.count);
});

/// What the scene draws: all release places, with their shares.
export interface DrawnSources {
  positions: Point3[];
  /// The longer side of a cell [m]; 0: not a cell.
  sizes: number[];
  /// 0 to 1: from no rock to the end of the scale.
  shares: number[];
  numbers: number[];
  high: number;
}
export const drawnSources = computed<DrawnSources | null>(() => {
  const [places, all] = [sourcePlaces.value, releases.value];
  if (!isAsking.value || !places || !all || sourceColour.value === 'none') return null;
  const shares = new Float64Array(all.rocks.length);
  for (const { number, share } of places) shares[number] = share;
  const high = Math.min(1, roundUp(places[0]?.share ?? 0) || 1);
  const { origin } = all.header;
  const numbers = Array.from(shares, (_, k) => k);
  return {
    positions: numbers.map((k): Point3 => [0, 1, 2].map((axis) => origin[axis]! + all.positions[3 * k + axis]!) as Point3),
    sizes: numbers.map((k) => Math.max(all.sizes[2 * k]!, all.sizes[2 * k + 1]!)),
    shares: Array.from(shares, (share) => Math.min(1, share / high)),
    numbers,
    high,
  };
});

export const sourceTitles: Record<SourceColour, string> = {
  crossing: 'share that crosses',
  clearing: 'share that clears the kit',
  none: 'not coloured',
};

export function sourceLegends(): LegendData[] {
  const drawn = drawnSources.value;
  if (!drawn) return [];
  const found = answer.value;
  const what = found?.kind === 'polygon' ? 'share that enters' : sourceTitles[found?.sources?.clearing ? 'clearing' : 'crossing'];
  return [
    { kind: 'scale', title: `Release places: ${what}, %`, stops: stopsOf(shareRamp[shade.value]), low: 0, high: 100 * drawn.high, isClipped: false },
  ];
}

/// Shows only the rocks of a release place; again: all.
export function toggleRelease(number: number) {
  const now = filter.peek();
  const isOnly = now.releases?.length === 1 && now.releases[0] === number;
  filterBy({ releases: isOnly ? null : [number] });
}

/// "Place 34, Crest, x 12.3, y 45.6 m: 16 of 20 rocks, 80 %"
export const sourceText = ({ number, name, where, count, rocks, share }: SourcePlace) =>
  `Place ${number + 1}${name && `, ${name}`}, ${where}: ${count.toLocaleString('en')} of ${counted(rocks, 'rock')}, ${percentText(share)}`;
