// What the page tells the user in passing.

import { signal } from '@preact/signals';

export interface Message {
  id: number;
  kind: 'saved' | 'note' | 'error';
  text: string;
  /// What was tried; when the same goes well, what is said against it goes.
  about: string | null;
}

export const messages = signal<Message[]>([]);
let next = 0;

/// An error stays until it is dismissed, or holds no more: what was tried goes well, or the project is left.
export function say(kind: Message['kind'], text: string, about: string | null = null) {
  if (messages.value.some((message) => message.kind === kind && message.text === text)) return;
  const id = next++;
  messages.value = [...messages.value, { id, kind, text, about }];
  if (kind !== 'error') setTimeout(() => dismiss(id), 4000);
}

const keep = (isKept: (message: Message) => boolean) => {
  if (!messages.peek().every(isKept)) messages.value = messages.peek().filter(isKept);
};

export const dismiss = (id: number) => keep((message) => message.id !== id);
export const settle = (about: string) => keep((message) => message.about !== about);
/// What is said against a project ends with it.
export const settleAll = () => keep(({ kind }) => kind !== 'error');

const isGivenUp = (error: unknown) => error instanceof DOMException && error.name === 'AbortError';

/// What went wrong, of something that nobody waits for.
export function sayFailure(error: unknown, about: string | null = null) {
  if (isGivenUp(error)) return;
  if (about !== null) settle(about);
  say('error', error instanceof Error ? error.message : String(error), about);
}

/// Tries something: what goes wrong is said, until it goes well.
export async function attempt<Answer>(about: string, task: () => Promise<Answer>): Promise<Answer | undefined> {
  try {
    const answer = await task();
    settle(about);
    return answer;
  } catch (error) {
    sayFailure(error, about);
    return undefined;
  }
}
