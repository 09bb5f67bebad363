// Whether the start page shows the verification cases.

import { signal, type ReadonlySignal } from '@preact/signals';

const shown = signal(false);
export const verifying: ReadonlySignal<boolean> = shown;
export const showVerification = (shows: boolean) => void (shown.value = shows);
