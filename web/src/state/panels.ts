// The panel at the left, and the tab and height of the results below the view. Their names are also those in addresses.

import type { ReadonlySignal } from '@preact/signals';
import { kept } from './kept';

export const sidePanels = ['model', 'runs', 'calibrate', 'text'] as const;
export type SidePanel = (typeof sidePanels)[number];

export const resultsTabs = [
  'overview',
  'distributions',
  'barriers',
  'rock',
  'envelopes',
  'maps',
  'compare',
  'section',
  'observed',
  'uncertainty',
  'calibration',
] as const;
export type ResultsTab = (typeof resultsTabs)[number];

const side = kept<SidePanel>('side panel', 'model');
export const sidePanel: ReadonlySignal<SidePanel> = side;
export const showPanel = (panel: SidePanel) => void (side.value = panel);

const tab = kept<ResultsTab>('results tab', 'overview');
export const resultsTab: ReadonlySignal<ResultsTab> = tab;
export const showTab = (name: ResultsTab) => void (tab.value = name);

const isOpen = kept('results open', true);
export const resultsOpen: ReadonlySignal<boolean> = isOpen;
export const openResults = (opens = true) => void (isOpen.value = opens);

const share = kept('results share', 0.34);
/// The height of the results, as a share of the window's.
export const resultsShare: ReadonlySignal<number> = share;
export const setResultsShare = (next: number) => void (share.value = next);
