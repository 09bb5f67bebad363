import type { Run } from '../api/types';
import { chosenRock } from '../state/view';

/// Which rock is looked at: rocks are numbered from 0.
export function RockChoice({ run }: { run: Run }) {
  const rock = chosenRock.value;
  const last = run.rocks - 1;
  const go = (to: number) => {
    if (Number.isInteger(to) && to >= 0 && to <= last) chosenRock.value = to;
  };
  return (
    <div class="tab-tools">
      <label class="choice">
        Rock
        <input
          type="number"
          min={0}
          max={last}
          step={1}
          style={{ width: `calc(${String(last).length + 5}ch + 3em)` }}
          value={rock ?? ''}
          placeholder={`0 to ${last}`}
          onChange={(event) => event.currentTarget.value !== '' && go(event.currentTarget.valueAsNumber)}
        />
      </label>
      <button class="button" disabled={rock === null || rock <= 0} onClick={() => go(rock! - 1)}>
        Previous
      </button>
      <button class="button" disabled={rock !== null && rock >= last} onClick={() => go((rock ?? -1) + 1)}>
        {rock === null ? 'First' : 'Next'}
      </button>
      {rock !== null && (
        <button class="button plain" onClick={() => (chosenRock.value = null)}>
          None
        </button>
      )}
    </div>
  );
}
