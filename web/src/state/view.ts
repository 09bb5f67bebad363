// How the page is looked at: what is chosen, which panels are open, light or dark.

import { signal } from '@preact/signals';
import type { Path } from '../model/names';
import { kept } from './kept';
import { ofProject } from './ofProject';

export type Theme = 'system' | 'light' | 'dark';

export const theme = kept<Theme>('theme', 'system');

export type SidePanel = 'model' | 'runs' | 'text';
export const sidePanel = kept<SidePanel>('side panel', 'model');

export type ResultsTab = 'overview' | 'distributions' | 'barriers' | 'rock' | 'envelopes' | 'maps' | 'compare' | 'section';
export const resultsTab = kept<ResultsTab>('results tab', 'overview');
export const resultsOpen = kept('results open', true);
/// Of the window's height.
export const resultsShare = kept('results share', 0.34);
/// Whether tables show numbers with all the digits that the files have.
export const allDigits = kept('all digits', false);

/// A thing of the project by its path, such as ["seeder", 0]: its form is open, and the scene marks it.
export const chosen = ofProject<Path | null>(null);
/// The rock of the run that is looked at.
export const chosenRock = ofProject<number | null>(null);
/// The map of the run that lies on the terrain, by its name.
export const drapedMap = ofProject<string | null>(null);
export const helpOpen = signal(false);
export const drapedOpacity = kept('opacity of the map', 1);
/// Whether the published cases are looked at, on the start page.
export const verifying = signal(false);
