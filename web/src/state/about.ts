// What the server says of itself, and of the folder that it works in.

import { signal } from '@preact/signals';
import type { About } from '../api/types';

export const about = signal<About | null>(null);

/// The folder's identity: what the browser keeps for a project belongs to it, since another folder that is served on
/// the same port can have a project of that name.
export const workplace = () => about.value?.workplace ?? '';
export const keptKey = (what: string, name: string) => `${what} in ${workplace()} of ${name}`;
