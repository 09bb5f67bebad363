// The trajectories of the shown run and of the compared one, as arrays for drawing in both views.

import { effect, signal, type ReadonlySignal } from '@preact/signals';
import { getArrays, Refused } from '../api/client';
import type { Point3, Run } from '../api/types';
import { reportFailure, resolve } from '../state/messages';
import { compared, hasResults, shown } from '../runs/runs';

/// A number of rocks, and their share with the ends of its confidence interval; null before the first rock.
export interface CountSoFar {
  name: string;
  rocks: number;
  share: [number, number, number] | null;
}
/// The counts of a run in progress, of all rocks that are finished.
export interface SoFar {
  done: number;
  planned: number;
  confidence: number;
  end_reasons: CountSoFar[];
  rocks_hit: CountSoFar[];
}

export interface PathsHeader {
  /// The number of rocks with a trajectory in paths.csv; the drawn ones are evenly selected from them.
  total: number;
  /// The origin of `positions`.
  origin: Point3;
  sources: string[];
  seeders: string[];
  reasons: string[];
  states: string[];
  barriers: string[];
  /// Whether rocks have shapes, and these are available.
  blocks?: boolean;
  /// Only while the run is in progress.
  so_far?: SoFar;
}

export interface DrawnPaths {
  run: string;
  header: PathsHeader;
  /// Rock k has the points from `starts[k]` up to, but excluding, `starts[k + 1]`.
  starts: Uint32Array;

  // For each point:
  times: Float32Array; // s
  positions: Float32Array; // three per point, m
  speeds: Float32Array; // m/s
  energies: Float32Array; // kJ
  heights: Float32Array; // above the ground, m; NaN: unknown
  states: Uint8Array;

  // For each rock:
  rocks: Uint32Array;
  sources: Uint16Array;
  seeders: Uint16Array;
  reasons: Uint8Array;
  releases?: Uint32Array; // the numbers of their release places; unknown without stored trajectories
  masses: Float32Array; // kg
  radii: Float32Array; // of the equivalent spheres, m
  maxEnergies: Float32Array; // kJ
  maxHeights: Float32Array; // m
  barriers: Uint32Array; // a bit set of the barriers that the rock hit, in words of 32 bits
}

const mostRocks = 10_000;
const mostKept = 4;
const kept = new Map<string, Promise<DrawnPaths>>();

async function load(run: Run, what: string, signal: AbortSignal): Promise<DrawnPaths> {
  const address = `/api/runs/${encodeURIComponent(run.id)}/${what}`;
  const { header, arrays } = await getArrays<PathsHeader>(address, signal);
  const { max_energies: maxEnergies, max_heights: maxHeights, ...others } = arrays;
  return { run: run.id, header, maxEnergies, maxHeights, ...others } as DrawnPaths;
}

// A resumed run has more trajectories than before.
const keyOf = (run: Run) => `${run.id} ${run.done}`;

function fetched(run: Run, signal: AbortSignal): Promise<DrawnPaths> {
  const key = keyOf(run);
  const answer = kept.get(key) ?? load(run, `paths?rocks=${mostRocks}`, signal);
  kept.delete(key);
  kept.set(key, answer);
  answer.catch(() => kept.get(key) === answer && kept.delete(key));
  for (const old of [...kept.keys()].slice(0, -mostKept)) kept.delete(old);
  return answer;
}

const betweenLooks = 1500; // ms

/// Looks at a run in progress from time to time, until `signal` is aborted.
async function watch(run: Run, signal: AbortSignal, take: (paths: DrawnPaths) => void) {
  for (;;) {
    await new Promise((done) => setTimeout(done, betweenLooks / 2)); // a short run is over before
    if (signal.aborted) return;
    try {
      take(await load(run, 'so_far', signal));
    } catch (error) {
      if (signal.aborted) return;
      // 404: it is not being simulated yet, or no longer. If the server does not respond, the top bar says so.
      if (error instanceof Refused && error.status !== 404) throw error;
    }
    await new Promise((done) => setTimeout(done, betweenLooks / 2));
  }
}

function pathsOf(run: ReadonlySignal<Run | null>): ReadonlySignal<DrawnPaths | null> {
  const paths = signal<DrawnPaths | null>(null);
  let asking: AbortController | undefined;
  let asked = '';
  effect(() => {
    const [now, isUnderWay] = [run.value, run.value?.state === 'running'];
    const key = !now ? '' : isUnderWay ? `${now.id} under way` : hasResults(now) ? keyOf(now) : '';
    if (key === asked) return;
    asked = key;
    asking?.abort();
    const own = (asking = new AbortController());
    // What a run had found so far stays until its results are there.
    if (paths.peek()?.run !== now?.id || key === '') paths.value = null;
    if (!now || key === '') return;
    const fail = (error: unknown) => {
      if (!own.signal.aborted) reportFailure(error, `paths of ${now.id}`);
    };
    if (isUnderWay) return void watch(now, own.signal, (found) => !own.signal.aborted && (paths.value = found)).catch(fail);
    fetched(now, own.signal).then(
      (found) => {
        resolve(`paths of ${now.id}`);
        if (!own.signal.aborted) paths.value = found.rocks.length > 0 ? found : null;
      },
      fail,
    );
  });
  return paths;
}

/// Null while loading, and if the run has none.
export const shownPaths = pathsOf(shown);
export const comparedPaths = pathsOf(compared);

/// The index of a rock among the drawn ones; -1 if it is not drawn.
export function indexOfRock({ rocks }: DrawnPaths, rock: number): number {
  let [low, high] = [0, rocks.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rocks[middle]! < rock) low = middle + 1;
    else high = middle;
  }
  return rocks[low] === rock ? low : -1;
}
