import { useEffect, useRef, useState } from 'preact/hooks';
import type { Run, RunState } from '../api/types';
import { areKnown, runs } from '../runs/runs';
import { stateText } from './RunStateText';

const isUnderWay = (state: RunState | undefined) => state === 'waiting' || state === 'running';

/// Announces the end of a run to screen readers.
export function RunEnds() {
  const before = useRef<Map<string, RunState> | null>(null);
  const [ended, setEnded] = useState<Run | null>(null);
  const now = areKnown.value ? runs.value : null;
  useEffect(() => {
    const known = before.current;
    before.current = now && new Map(now.map(({ id, state }) => [id, state]));
    // A quick run may have ended before it was first reported.
    const hasJustEnded = ({ id, state }: Run) => !isUnderWay(state) && (!known!.has(id) || isUnderWay(known!.get(id)));
    const run = known && now?.find(hasJustEnded);
    if (run) setEnded(run);
  }, [now]);
  return (
    <div class="visually-hidden" role="status">
      {ended && <span key={ended.id}>{`${ended.name}: ${stateText(ended)}`}</span>}
    </div>
  );
}
