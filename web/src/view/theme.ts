// The light or dark theme, and its colours for canvases.

import { effect, signal, type ReadonlySignal } from '@preact/signals';
import { kept } from '../state/kept';

export type Theme = 'system' | 'light' | 'dark';
const themes: Theme[] = ['system', 'light', 'dark'];

const chosen = kept<Theme>('theme', 'system');
export const theme: ReadonlySignal<Theme> = chosen;
export const nextTheme = () => void (chosen.value = themes[(themes.indexOf(chosen.peek()) + 1) % themes.length]!);

const media = matchMedia('(prefers-color-scheme: dark)');
const systemIsDark = signal(media.matches);
media.addEventListener('change', () => (systemIsDark.value = media.matches));

export const shade = signal<'light' | 'dark'>('light');
effect(() => {
  const now = theme.value === 'system' ? (systemIsDark.value ? 'dark' : 'light') : theme.value;
  document.documentElement.dataset.theme = now;
  shade.value = now; // set after the CSS colours, which are read when it changes
});

/// The colour of the shown or the compared run.
export function runColour(which: 'shown' | 'compared'): string {
  void shade.value;
  return cssColour(`--run-${which}`);
}

/// A colour of theme.css by name, such as "--text". It changes with `shade`.
export const cssColour = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// Runs a synchronous task in the light theme, for print.
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
