// Which line the page answers for, and its name.

import { missingPoints, type Asked } from '../askLine/shape';

export interface RunBarrier {
  name: string;
  kind: 'barrier' | 'collector';
}
/// What rocks must not reach, as engineers name it.
const protectedName = /road|street|highway|motorway|rail|track|house|stra(ss|ß)e|strada|route|bahn/i;

/// The place that is answered for; null: none is chosen.
export function placeOf(now: Asked | null, dimension: 2 | 3, barriers: readonly RunBarrier[]): Asked | null {
  if (now && missingPoints(now, dimension) === 0) return now;
  const collectors = barriers.filter(({ kind }) => kind === 'collector');
  const found = collectors.find(({ name }) => protectedName.test(name)) ?? collectors[0] ?? barriers[0];
  return found ? { kind: 'barrier', name: found.name } : null;
}
