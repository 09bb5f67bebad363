// One rock: its trajectory, event by event.

import { results } from '../api/results';
import type { Run } from '../api/types';
import { chosenRock } from '../runs/chosenRock';
import { useRemote } from '../ui/remote';
import { RockChoice } from './RockChoice';
import { RockEnergy } from './RockEnergy';
import { HitsTable, PathTable, RockFacts } from './rockTables';
import { Waiting } from '../ui/Waiting';

export function Rock({ run }: { run: Run }) {
  const rock = chosenRock.value;
  const answer = useRemote(run.id, rock === null ? null : `${run.done} ${rock}`, async (signal) => ({
    rock: rock!,
    path: await results.rock(run.id, rock!, signal),
  }));
  return (
    <div class="tab-page">
      <RockChoice run={run} />
      {rock === null ? (
        <div class="empty">Click a trajectory in the view, or enter the number of a rock.</div>
      ) : !answer.value ? (
        <Waiting of={answer} />
      ) : (
        <div class="rock">
          <RockFacts endpoint={answer.value.path.endpoint} />
          <PathTable run={run} rock={answer.value.rock} path={answer.value.path} />
          <div class="figures">
            <RockEnergy run={run} rock={answer.value.rock} path={answer.value.path} />
          </div>
          <HitsTable run={run} rock={answer.value.rock} path={answer.value.path} />
        </div>
      )}
    </div>
  );
}
