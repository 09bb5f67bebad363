// The panel at the left, and the tab and height of the results below the view. Their names are also those in addresses.

import { kept } from './kept';
import { owned } from './owned';

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

export const [sidePanel, showPanel] = owned(kept<SidePanel>('side panel', 'model'));

export const [resultsTab, showTab] = owned(kept<ResultsTab>('results tab', 'overview'));
const [isOpen, setOpen] = owned(kept('results open', true));
export const resultsOpen = isOpen;
export const openResults = (opens = true) => setOpen(opens);
/// The height of the results, as a share of the window's.
export const [resultsShare, setResultsShare] = owned(kept('results share', 0.34));
