// A signal with one owner: others read it, and change it only by the functions of the module that has it.

import type { ReadonlySignal, Signal } from '@preact/signals';

/// What readers get, and the function that sets its value.
export const owned = <T>(own: Signal<T>): [ReadonlySignal<T>, (next: T) => void] => [own, (next) => void (own.value = next)];
