import { useEffect, useRef, useState } from 'preact/hooks';
import type { Run, RunState } from '../api/types';
import { areKnown, runs } from '../state/runs';
import { stateText } from './RunStateText';

const isUnderWay = (state: RunState | undefined) => state === 'waiting' || state === 'running';

/// Tells who does not see it that a run has ended.
export function RunEnds() {
  const before = useRef<Map<string, RunState> | null>(null);
  const [ended, say] = useState<Run | null>(null);
  const now = areKnown.value ? runs.value : null;
  useEffect(() => {
    const known = before.current;
    before.current = now && new Map(now.map(({ id, state }) => [id, state]));
    // One that is quick may have ended before it was heard of.
    const isNews = ({ id, state }: Run) => !isUnderWay(state) && (!known!.has(id) || isUnderWay(known!.get(id)));
    const news = known && now?.find(isNews);
    if (news) say(news);
  }, [now]);
  return (
    <div class="visually-hidden" role="status">
      {ended && <span key={ended.id}>{`${ended.name}: ${stateText(ended)}`}</span>}
    </div>
  );
}
