// The trajectories of the corridor as lines of the section's figure, in the colours of the views.

import { computed } from '@preact/signals';
import type { Traces } from '../figures/profile';
import { colouring } from '../paths/colouring';
import { shownPaths } from '../paths/drawnPaths';
import { shownPassing } from '../paths/shownPassing';
import { rockColours } from '../paths/rockColours';
import { corridorWidth } from './corridorSettings';
import { pathsInCorridor, type CorridorPaths } from './corridor';
import { sectionLine } from './sectionLine';

const mostDrawn = 1500; // rocks; more would only cover each other

/// The trajectories beside the line; null without a line or a run.
export const corridorPaths = computed<CorridorPaths | null>(() => {
  const [line, paths] = [sectionLine.value, shownPaths.value];
  if (!line || line.length < 2 || !paths) return null;
  return pathsInCorridor(paths, line, corridorWidth.value, shownPassing.value);
});

/// The rocks that are drawn, evenly selected: every n-th of those in the corridor.
const interval = (count: number) => Math.max(1, Math.ceil(count / mostDrawn));
export const drawnCount = computed(() => {
  const count = corridorPaths.value?.rockCount ?? 0;
  return Math.ceil(count / interval(count));
});

/// Lines by colour.
export const corridorTraces = computed<Traces[]>(() => {
  const [found, how] = [corridorPaths.value, colouring.value];
  if (!found || !how) return [];
  const colour = rockColours(how);
  const every = interval(found.rockCount);
  const byColour = new Map<string, [number, number][][]>();
  let [number, last] = [-1, -1];
  found.rocks.forEach((rock, part) => {
    if (rock !== last) [number, last] = [number + 1, rock];
    if (number % every !== 0) return;
    let now = '';
    for (let k = found.starts[part]!; k < found.starts[part + 1]!; ++k) {
      const place: [number, number] = [found.distances[k]!, found.elevations[k]!];
      const next = colour(found.points[k]!, rock);
      if (next !== now) {
        const lines = byColour.get(next) ?? [];
        byColour.set(next, lines);
        // A line begins at the last point of the one before.
        lines.push(now === '' ? [] : [[found.distances[k - 1]!, found.elevations[k - 1]!]]);
        now = next;
      }
      byColour.get(next)!.at(-1)!.push(place);
    }
  });
  return [...byColour].map(([css, lines]) => ({ colour: css, lines }));
});
