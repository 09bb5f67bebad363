// The state of the page: selection, open panels, theme.

import { signal } from '@preact/signals';
import type { Path } from '../settings/names';
import { kept } from './kept';
import { keptOfProject, ofProject } from '../project/ofProject';
import type { ResultsTab, SidePanel } from './tabs';

export type { ResultsTab, SidePanel };

export type Theme = 'system' | 'light' | 'dark';

export const theme = kept<Theme>('theme', 'system');

export const sidePanel = kept<SidePanel>('side panel', 'model');

export const resultsTab = kept<ResultsTab>('results tab', 'overview');
export const resultsOpen = kept('results open', true);
/// As a share of the window's height.
export const resultsShare = kept('results share', 0.34);
/// Whether tables show all digits of the files.
export const allDigits = kept('all digits', false);

/// The path of the selected entry, such as ["seeder", 0], whose form is open and which the views highlight.
export const chosen = ofProject<Path | null>(null);
/// The selected rock of the shown run.
export const chosenRock = ofProject<number | null>(null);
/// The name of the map that is draped over the terrain.
export const drapedMap = ofProject<string | null>(null);
/// Whether a line is asked: its card is open.
export const isAsking = keptOfProject<boolean>('asking a line', false);
/// What is asked, as text (askLine/shape.ts); empty: nothing.
export const askedText = keptOfProject<string>('asked line', '');
export const helpOpen = signal(false);
export const drapedOpacity = kept('opacity of the map', 1);
/// Whether the start page shows the verification cases.
export const verifying = signal(false);
