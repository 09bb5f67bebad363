import { openPane, slopePane } from './state';

export function SlopeButton() {
  const isOn = slopePane.value !== null;
  return (
    <button class="button" aria-pressed={isOn} title="Bench, ditch, berm, regrading; what stays in a ditch" onClick={() => openPane(isOn ? null : 'ditch')}>
      Slope tools
    </button>
  );
}
