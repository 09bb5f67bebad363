// Stores typed text before any action on the project. Leaving a field ends a step of Undo.

import { endStep } from './document';
import { storeOnLeaving } from './drafts';

export const isWriting = (target: EventTarget | null) =>
  target instanceof HTMLElement &&
  (target.isContentEditable || ['INPUT', 'TEXTAREA', 'SELECT'].includes(target.tagName));

/// Stores the text of the focused field by a change event.
function storeTyped() {
  if (isWriting(document.activeElement)) document.activeElement?.dispatchEvent(new Event('change', { bubbles: true }));
}

export function afterTyping(action: () => unknown) {
  storeTyped();
  endStep();
  void action();
}

const onLeaving = () => afterTyping(storeOnLeaving);

export function listenToTyping(): () => void {
  addEventListener('focusout', endStep);
  addEventListener('pagehide', onLeaving);
  return () => {
    removeEventListener('focusout', endStep);
    removeEventListener('pagehide', onLeaving);
  };
}
