// What is being typed counts before anything is done with the project; and where a field is left, a step ends.

import { endStep } from '../state/document';
import { keepOnLeaving } from '../state/drafts';

export const isWriting = (target: EventTarget | null) =>
  target instanceof HTMLElement &&
  (target.isContentEditable || ['INPUT', 'TEXTAREA', 'SELECT'].includes(target.tagName));

/// A field takes it when it changes.
function takeTyped() {
  if (isWriting(document.activeElement)) document.activeElement?.dispatchEvent(new Event('change', { bubbles: true }));
}

export function taken(what: () => unknown) {
  takeTyped();
  endStep();
  void what();
}

const onLeaving = () => taken(keepOnLeaving);

export function listenToTyping(): () => void {
  addEventListener('focusout', endStep);
  addEventListener('pagehide', onLeaving);
  return () => {
    removeEventListener('focusout', endStep);
    removeEventListener('pagehide', onLeaving);
  };
}
