// Whether tables show all digits of the files.

import type { ReadonlySignal } from '@preact/signals';
import { kept } from '../state/kept';

const all = kept('all digits', false);
export const allDigits: ReadonlySignal<boolean> = all;
export const showAllDigits = (shows: boolean) => void (all.value = shows);
