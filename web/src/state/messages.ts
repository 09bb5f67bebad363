// Messages of the page to the user.

import { signal } from '@preact/signals';

export interface Message {
  id: number;
  kind: 'saved' | 'note' | 'error';
  text: string;
  /// The action that failed; its success removes the message.
  about: string | null;
}

export const messages = signal<Message[]>([]);
let next = 0;

/// Shows a message. An error stays until it is dismissed, the action succeeds, or the project is closed.
export function notify(kind: Message['kind'], text: string, about: string | null = null) {
  if (messages.value.some((message) => message.kind === kind && message.text === text)) return;
  const id = next++;
  messages.value = [...messages.value, { id, kind, text, about }];
  if (kind !== 'error') setTimeout(() => dismiss(id), 4000);
}

const keep = (isKept: (message: Message) => boolean) => {
  if (!messages.peek().every(isKept)) messages.value = messages.peek().filter(isKept);
};

export const dismiss = (id: number) => keep((message) => message.id !== id);
export const resolve = (about: string) => keep((message) => message.about !== about);
/// Removes all errors when the project is closed.
export const resolveAll = () => keep(({ kind }) => kind !== 'error');

const isAborted = (error: unknown) => error instanceof DOMException && error.name === 'AbortError';

/// Shows an error, unless a request was aborted on purpose.
export function reportFailure(error: unknown, about: string | null = null) {
  if (isAborted(error)) return;
  if (about !== null) resolve(about);
  notify('error', error instanceof Error ? error.message : String(error), about);
}

/// Runs a task. A failure is shown until the same action succeeds.
export async function attempt<Answer>(about: string, task: () => Promise<Answer>): Promise<Answer | undefined> {
  try {
    const answer = await task();
    resolve(about);
    return answer;
  } catch (error) {
    reportFailure(error, about);
    return undefined;
  }
}
