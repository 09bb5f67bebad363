// Asks what a dropped file is.

import { Dialog } from '../ui/Dialog';
import { dropped, useDropped } from './dropped';
import { choicesFor } from './uses';
import './layers.css';

export function DropDialog() {
  const now = dropped.value;
  if (!now) return null;
  const { name, kind, shapes, isReading, problems } = now;
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
          {choicesFor(kind, shapes).map(({ use, title, what }) => (
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
