// Keys that work everywhere on the page.

import { file, redo, undo } from '../state/document';
import { save } from '../state/saving';
import { compute } from '../state/runs';
import { finishTool, takeBack, tool, useTool } from '../scene/tool';
import { isWriting, taken } from './typing';

/// A field with something typed in it has an undo of its own; one that shows what the project says has none.
const undoesItself = (target: EventTarget | null) =>
  isWriting(target) &&
  !(target instanceof HTMLSelectElement) &&
  !(target instanceof HTMLInputElement && target.type !== 'text') &&
  (target as HTMLElement).dataset.clean === undefined;

function onKey(event: KeyboardEvent) {
  if (file.value === null) return;
  const ctrl = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  const act = (what: () => unknown) => {
    event.preventDefault();
    void what();
  };
  if (ctrl && key === 's') return act(() => taken(save));
  if (ctrl && event.key === 'Enter') return act(() => taken(compute));
  if (undoesItself(event.target)) return;
  if (ctrl && key === 'z') return act(event.shiftKey ? redo : undo);
  if (ctrl && key === 'y') return act(redo);
  if (!tool.value || isWriting(event.target)) return;
  if (event.key === 'Escape') return act(() => useTool(null));
  if (event.key === 'Enter' && event.target === document.body) return act(finishTool);
  if (event.key === 'Backspace') return act(takeBack);
}

export function listenToKeys(): () => void {
  addEventListener('keydown', onKey);
  return () => removeEventListener('keydown', onKey);
}
