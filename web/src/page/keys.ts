// Keyboard shortcuts of the whole page.

import { file, redo, undo } from '../project/document';
import { save } from '../project/saving';
import { compute } from '../runs/runs';
import { finishTool, removeLastPoint, tool, useTool } from '../tools/tool';
import { afterTyping, isWriting } from '../project/typing';

/// Whether an element has its own Undo: a field with typed text that is not stored yet.
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
  if (ctrl && key === 's') return act(() => afterTyping(save));
  if (ctrl && event.key === 'Enter') return act(() => afterTyping(compute));
  if (undoesItself(event.target)) return;
  if (ctrl && key === 'z') return act(event.shiftKey ? redo : undo);
  if (ctrl && key === 'y') return act(redo);
  if (!tool.value || isWriting(event.target)) return;
  if (event.key === 'Escape') return act(() => useTool(null));
  if (event.key === 'Enter' && event.target === document.body) return act(finishTool);
  if (event.key === 'Backspace') return act(removeLastPoint);
}

export function listenToKeys(): () => void {
  addEventListener('keydown', onKey);
  return () => removeEventListener('keydown', onKey);
}
