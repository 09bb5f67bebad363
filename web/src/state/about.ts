// The server's version, folder and limits.

import { signal } from '@preact/signals';
import type { About } from '../api/types';
import { owned } from './owned';

export const [about, setAbout] = owned(signal<About | null>(null));

/// Identifies the folder. Data that the browser stores for a project is bound to it, because another folder served on the
/// same port can have a project of the same name.
export const workplace = () => about.value?.workplace ?? '';
export const storageKey = (what: string, name: string) => `${what} in ${workplace()} of ${name}`;
