import type { Signal } from '@preact/signals';

/// Whether numbers are shown as the files have them, or rounded for reading.
export function DigitsSwitch({ all }: { all: Signal<boolean> }) {
  return (
    <label class="switch">
      <input type="checkbox" checked={all.value} onChange={(event) => (all.value = event.currentTarget.checked)} />
      All digits
    </label>
  );
}
