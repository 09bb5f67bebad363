// The blocks among the drawn rocks, as arrays for drawing in both views: their hulls and poses.

import { effect, signal, type ReadonlySignal } from '@preact/signals';
import { askArrays, Refused } from '../api/client';
import type { Point3 } from '../api/types';
import { reportFailure } from '../state/messages';
import { chosenRock } from '../runs/chosenRock';
import { blockRocks } from './blockRocks';
import { comparedPaths, indexOfRock, shownPaths, type DrawnPaths } from './drawnPaths';
import { comparedPassing, shownPassing } from './shownPassing';

export interface DrawnBlocks {
  paths: DrawnPaths;
  /// The origin of `positions`.
  origin: Point3;
  /// The index of each block among the drawn rocks.
  drawn: Uint32Array;
  // The first corner, triangle and pose of each block, and the number of all at the end.
  cornerStarts: Uint32Array;
  triangleStarts: Uint32Array;
  poseStarts: Uint32Array;

  corners: Float32Array; // three per corner, in the frame of the block, m
  triangles: Uint32Array; // three corners of the block each; none in a section

  // For each pose:
  times: Float32Array; // s
  positions: Float32Array; // of the centre, three per pose, m
  turns: Float32Array; // quaternions x, y, z, w, from the frame of the block
}

async function load(paths: DrawnPaths, rocks: number[], stop: AbortSignal): Promise<DrawnBlocks> {
  const address = `/api/runs/${encodeURIComponent(paths.run)}/blocks`;
  const { header, arrays } = await askArrays<{ origin: Point3 }>(address, { rocks }, stop);
  const { corner_starts: cornerStarts, triangle_starts: triangleStarts, pose_starts: poseStarts, rocks: found, ...others } = arrays;
  const drawn = Uint32Array.from(found!, (rock) => indexOfRock(paths, rock));
  return { paths, origin: header.origin, drawn, cornerStarts, triangleStarts, poseStarts, ...others } as DrawnBlocks;
}

// Requests in progress.
const pending = new Set<Promise<unknown>>();

/// For pictures that must have all blocks: waits until those that are being loaded are there.
export const blocksLoaded = async () => void (await Promise.allSettled(pending));

/// Null without blocks, while the first ones load, and if the files of the project have changed since the run.
function blocksOf(
  paths: ReadonlySignal<DrawnPaths | null>,
  passing: ReadonlySignal<Uint8Array | null>,
  chosen: ReadonlySignal<number | null>,
): ReadonlySignal<DrawnBlocks | null> {
  const blocks = signal<DrawnBlocks | null>(null);
  let asking: AbortController | undefined;
  let asked: { paths: DrawnPaths; rocks: Set<number> } | null = null;
  effect(() => {
    const [now, passes, rock] = [paths.value, passing.value, chosen.value];
    if (asked && asked.paths !== now) {
      asking?.abort();
      asked = blocks.value = null;
    }
    if (!now?.header.blocks) return;
    const rocks = blockRocks(now.rocks, passes, rock !== null && indexOfRock(now, rock) >= 0 ? rock : null);
    if (rocks.length === 0 || rocks.every((each) => asked?.rocks.has(each))) return;
    asking?.abort();
    const own = (asking = new AbortController());
    asked = { paths: now, rocks: new Set(rocks) };
    const loading = load(now, rocks, own.signal).then(
      (found) => {
        if (!own.signal.aborted) blocks.value = found;
      },
      (error: unknown) => {
        // 404: the files have changed since the paths were loaded. Dots stay.
        if (!own.signal.aborted && !(error instanceof Refused && error.status === 404)) reportFailure(error, `blocks of ${now.run}`);
      },
    );
    pending.add(loading);
    void loading.finally(() => pending.delete(loading));
  });
  return blocks;
}

export const shownBlocks = blocksOf(shownPaths, shownPassing, chosenRock);
export const comparedBlocks = blocksOf(comparedPaths, comparedPassing, signal(null));
