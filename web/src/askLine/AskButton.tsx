import { isAsking, openCard } from './asked';

export function AskButton() {
  const isOn = isAsking.value;
  return (
    <button
      class="button"
      aria-pressed={isOn}
      title="Which rocks cross a line, and what would stop them there"
      onClick={() => openCard(!isOn)}
    >
      Ask a line
    </button>
  );
}
