// The panels at the left and the tabs of the results, by their names in addresses.

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
