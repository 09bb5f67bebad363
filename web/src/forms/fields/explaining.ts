// Whether every setting of a form is explained.

import { signal, type ReadonlySignal } from '@preact/signals';

const all = signal(false);
export const explainsAll: ReadonlySignal<boolean> = all;
export const toggleExplaining = () => void (all.value = !all.peek());
