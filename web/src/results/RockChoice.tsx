import { useState } from 'preact/hooks';
import type { Run } from '../api/types';
import { chooseRock, chosenRock } from '../runs/chosenRock';

/// The choice of a rock by its zero-based number.
export function RockChoice({ run }: { run: Run }) {
  const [invalid, setInvalid] = useState<string | null>(null);
  const rock = chosenRock.value;
  const last = run.rocks - 1;
  const go = (to: number) => {
    setInvalid(null);
    chooseRock(to);
  };
  /// An invalid number is replaced by that of the shown rock.
  const take = (field: HTMLInputElement) => {
    const to = field.valueAsNumber;
    if (Number.isInteger(to) && to >= 0 && to <= last) return go(to);
    if (field.value !== '') setInvalid(field.value);
    field.value = String(rock ?? '');
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
          onChange={(event) => take(event.currentTarget)}
        />
      </label>
      <button class="button" disabled={rock === null || rock <= 0} onClick={() => go(rock! - 1)}>
        Previous
      </button>
      <button class="button" disabled={rock !== null && rock >= last} onClick={() => go((rock ?? -1) + 1)}>
        {rock === null ? 'First' : 'Next'}
      </button>
      {rock !== null && (
        <button class="button plain" onClick={() => chooseRock(null)}>
          None
        </button>
      )}
      {invalid !== null && (
        <span class="problem" role="status">
          There is no rock {invalid}. Rocks are numbered from 0 to {last}.
        </span>
      )}
    </div>
  );
}
