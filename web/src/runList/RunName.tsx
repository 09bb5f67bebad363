import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Run } from '../api/types';
import { rename } from '../runs/runs';
import { focusOnceMade } from '../ui/focus';

/// The name of a run; a click turns it into an input.
export function RunName({ run }: { run: Run }) {
  const [isOpen, open] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const endedByKey = useRef(false);
  useLayoutEffect(() => {
    if (!isOpen && endedByKey.current) button.current?.focus();
    endedByKey.current = false;
  }, [isOpen]);
  if (!isOpen)
    return (
      <button
        ref={button}
        class="run-name"
        title="Rename"
        aria-label={`${run.name}: rename`}
        onClick={() => open(true)}
      >
        {run.name}
      </button>
    );
  const take = (name: string) => {
    if (name && name !== run.name) void rename(run.id, name);
  };
  const end = (input: HTMLInputElement, key?: string) => {
    if (key !== 'Escape') take(input.value.trim());
    endedByKey.current = key !== undefined;
    open(false);
  };
  return (
    <input
      class="run-name"
      aria-label="Name of the run"
      defaultValue={run.name}
      maxLength={200}
      ref={focusOnceMade}
      onFocus={(event) => event.currentTarget.select()}
      // Removing the input also fires blur.
      onBlur={(event) => !endedByKey.current && end(event.currentTarget)}
      onKeyDown={(event) => {
        if (event.key !== 'Enter' && event.key !== 'Escape') return;
        event.preventDefault(); // Enter would also press the button
        end(event.currentTarget, event.key);
      }}
    />
  );
}
