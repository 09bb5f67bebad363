// The slope of a 2D model, from the engine.

import { effect, signal } from '@preact/signals';
import { getJson, Refused } from '../api/client';
import type { Point2 } from '../api/types';
import { reportFailure } from '../state/messages';
import { build, model } from './model';
import { distanceToLine } from '../geometry/nearness';

export interface Profile {
  model: string;
  /// From left to right.
  vertices: Point2[];
  materials: number[];
  /// As the project numbers them: descending if its section runs leftwards.
  segments: number[];
}

/// The profile of the last valid model.
export const profile = signal<Profile | null>(null);

async function fetchProfile(id: string, asking: AbortSignal) {
  try {
    const answer = await getJson<Omit<Profile, 'model'>>(`/api/models/${id}/profile`, asking);
    if (!asking.aborted) profile.value = { ...answer, model: id };
  } catch (error) {
    if (asking.aborted) return;
    // The server no longer has the model: build it again.
    if (error instanceof Refused && error.status === 404) void build();
    else reportFailure(error);
  }
}

effect(() => {
  const now = model.value;
  if (!now || now.dimension !== 2) {
    profile.value = null;
    return;
  }
  const asking = new AbortController();
  void fetchProfile(now.id, asking.signal);
  return () => asking.abort();
});

/// In the order of the project.
export const asListed = ({ vertices, segments }: Profile) => (segments[0]! > segments.at(-1)! ? vertices.toReversed() : vertices);

/// The ground at x and its segment; null outside the slope.
export function groundBelow({ vertices }: Profile, x: number): { z: number; segment: number } | null {
  for (let k = 0; k + 1 < vertices.length; ++k) {
    const [a, b] = [vertices[k]!, vertices[k + 1]!];
    const [low, high] = a[0] <= b[0] ? [a, b] : [b, a];
    if (x < low[0] || x > high[0] || low[0] === high[0]) continue;
    const share = (x - low[0]) / (high[0] - low[0]);
    return { z: low[1] + share * (high[1] - low[1]), segment: k };
  }
  return null;
}

/// The segment nearest to a point, and its distance [m], with heights multiplied by `stretch`.
export function nearestSegment({ vertices }: Profile, x: number, z: number, stretch: number): { segment: number; distance: number } {
  let best = { segment: 0, distance: Infinity };
  for (let k = 0; k + 1 < vertices.length; ++k) {
    const [[ax, az], [bx, bz]] = [vertices[k]!, vertices[k + 1]!];
    const distance = distanceToLine([x, z * stretch], [ax, az * stretch], [bx, bz * stretch]);
    if (distance < best.distance) best = { segment: k, distance };
  }
  return best;
}
