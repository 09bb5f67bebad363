// Whether the page is light or dark now, and its colours for pictures that CSS does not reach.

import { computed, signal } from '@preact/signals';
import { theme } from '../state/view';

const media = matchMedia('(prefers-color-scheme: dark)');
const systemIsDark = signal(media.matches);
media.addEventListener('change', () => (systemIsDark.value = media.matches));

export const shade = computed<'light' | 'dark'>(() =>
  theme.value === 'system' ? (systemIsDark.value ? 'dark' : 'light') : theme.value,
);

/// A colour of theme.css by its name, such as "--text". Read it again when `shade` changes.
export const cssColour = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
