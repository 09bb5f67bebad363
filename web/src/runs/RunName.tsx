import { useState } from 'preact/hooks';
import type { Run } from '../api/types';
import { rename } from '../state/runs';
import { focusOnceMade } from '../ui/focus';

/// The name of a run; a click makes it a field.
export function RunName({ run }: { run: Run }) {
  const [isOpen, open] = useState(false);
  if (!isOpen)
    return (
      <button class="run-name" title="Rename" aria-label={`${run.name}: rename`} onClick={() => open(true)}>
        {run.name}
      </button>
    );
  const end = (name: string) => {
    open(false);
    if (name && name !== run.name) void rename(run.id, name);
  };
  return (
    <input
      class="run-name"
      aria-label="Name of the run"
      defaultValue={run.name}
      maxLength={200}
      ref={focusOnceMade}
      onFocus={(event) => event.currentTarget.select()}
      onBlur={(event) => end(event.currentTarget.value.trim())}
      onKeyDown={(event) => {
        if (event.key === 'Enter') end(event.currentTarget.value.trim());
        if (event.key === 'Escape') open(false);
      }}
    />
  );
}
