import { allDigits, showAllDigits } from './allDigits';

/// Switches between rounded numbers and all digits of the files.
export function DigitsSwitch() {
  return (
    <label class="switch">
      <input type="checkbox" checked={allDigits.value} onChange={(event) => showAllDigits(event.currentTarget.checked)} />
      All digits
    </label>
  );
}
