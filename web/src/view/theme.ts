// Whether the page is light or dark now, and its colours for pictures that CSS does not reach.

import { effect, signal } from '@preact/signals';
import { theme } from '../state/view';

const media = matchMedia('(prefers-color-scheme: dark)');
const systemIsDark = signal(media.matches);
media.addEventListener('change', () => (systemIsDark.value = media.matches));

export const shade = signal<'light' | 'dark'>('light');
effect(() => {
  const now = theme.value === 'system' ? (systemIsDark.value ? 'dark' : 'light') : theme.value;
  document.documentElement.dataset.theme = now;
  shade.value = now; // after the colours, which are read when it changes
});

/// Of the run that is shown, and of the one that is compared with it.
export function runColour(which: 'shown' | 'compared'): string {
  void shade.value;
  return cssColour(`--run-${which}`);
}

/// A colour of theme.css by its name, such as "--text". Read it again when `shade` changes.
export const cssColour = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
