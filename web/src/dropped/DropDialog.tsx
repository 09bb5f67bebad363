// Asks what a dropped file is.

import { Dialog } from '../ui/Dialog';
import { dropped, setDropped, useDropped } from './dropped';
import './dropped.css';

export function DropDialog() {
  const now = dropped.value;
  if (!now) return null;
  const { name, isReading, choices, problems } = now;
  // Browsers say that a dialog is closed with the next frame, when another file may have been dropped.
  const close = () => {
    if (dropped.peek()?.name === name) setDropped(null);
  };
  return (
    <Dialog key={name} title={`What is ${name}?`} close={close}>
      {problems.map(({ text, severity }) => (
        <p key={text} class={`problem ${severity}`}>
          {text}
        </p>
      ))}
      {isReading ? (
        <p class="faint">Reading…</p>
      ) : (
        <div class="drop-uses">
          {choices.map(({ use, title, what }) => (
            <button key={use} class="button" onClick={() => useDropped(now, use)}>
              <span>{title}</span>
              <span class="faint">{what}</span>
            </button>
          ))}
        </div>
      )}
    </Dialog>
  );
}
