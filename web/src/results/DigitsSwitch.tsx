import type { Signal } from '@preact/signals';

/// Switches between rounded numbers and all digits of the files.
export function DigitsSwitch({ all }: { all: Signal<boolean> }) {
  return (
    <label class="switch">
      <input type="checkbox" checked={all.value} onChange={(event) => (all.value = event.currentTarget.checked)} />
      All digits
    </label>
  );
}
