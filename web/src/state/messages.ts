// What the page tells the user in passing.

import { signal } from '@preact/signals';

export interface Message {
  id: number;
  kind: 'saved' | 'note' | 'error';
  text: string;
}

export const messages = signal<Message[]>([]);
let next = 0;

export function say(kind: Message['kind'], text: string) {
  if (messages.value.some((message) => message.kind === kind && message.text === text)) return;
  const id = next++;
  messages.value = [...messages.value, { id, kind, text }];
  // An error stays until it is dismissed.
  if (kind !== 'error') setTimeout(() => dismiss(id), 4000);
}

export function dismiss(id: number) {
  messages.value = messages.value.filter((message) => message.id !== id);
}

/// For promises that nobody waits for: what goes wrong is said.
export function sayFailure(error: unknown) {
  if (error instanceof DOMException && error.name === 'AbortError') return;
  say('error', error instanceof Error ? error.message : String(error));
}
