// Asks what a dropped file is.

import { Dialog } from '../ui/Dialog';
import { dropped, useDropped } from './dropped';
import './layers.css';

export function DropDialog() {
  const now = dropped.value;
  if (!now) return null;
  const { name, isReading, choices, problems } = now;
  return (
    <Dialog key={name} title={`What is ${name}?`} close={() => (dropped.value = null)}>
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
