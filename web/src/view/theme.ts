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

/// Does something in the light colours of paper, whatever the page has. The page is not seen meanwhile.
export function inLight<T>(task: () => T): T {
  const before = shade.peek();
  const show = (next: 'light' | 'dark') => {
    if (shade.peek() === next) return;
    document.documentElement.dataset.theme = next;
    shade.value = next;
  };
  try {
    show('light');
    return task();
  } finally {
    show(before);
  }
}
