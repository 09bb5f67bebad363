// The panel at the left, and the tab and height of the results below the view. Their names are also those in addresses.

import { batch, type ReadonlySignal } from '@preact/signals';
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

/// The panel at the left, and what chooses it without unfolding it, as addresses do.
export const [sidePanel, turnToPanel] = owned(kept<SidePanel>('side panel', 'model'));
const [sideFolded, sideStays] = [kept('side folded', false), kept('side stays', false)];
export const isSideFolded: ReadonlySignal<boolean> = sideFolded;
/// Shows a panel.
export const showPanel = (panel: SidePanel) =>
  batch(() => {
    turnToPanel(panel);
    sideFolded.value = false;
  });
/// What the user chooses: a panel that is brought back stays when runs end, until it is folded by hand.
export const foldSide = (folds: boolean) =>
  batch(() => {
    sideFolded.value = folds;
    sideStays.value = !folds;
  });

export const [resultsTab, showTab] = owned(kept<ResultsTab>('results tab', 'overview'));
const [isOpen, resultsStay] = [kept('results open', true), kept('results stay', false)];
export const resultsOpen: ReadonlySignal<boolean> = isOpen;
export const openResults = (opens = true) => void (isOpen.value = opens);
/// What the user chooses: results that are opened stay when runs end, until they are hidden by hand.
export const keepResults = (opens: boolean) =>
  batch(() => {
    isOpen.value = opens;
    resultsStay.value = opens;
  });

/// The answers of a run come first: forms and tables fold away, unless they are to stay.
export const foldForAnswers = () =>
  batch(() => {
    if (!sideStays.peek()) sideFolded.value = true;
    if (!resultsStay.peek()) isOpen.value = false;
  });
/// A project without results needs its forms.
export const unfoldForms = () => void (sideFolded.value = false);
/// The height of the results, as a share of the window's.
export const [resultsShare, setResultsShare] = owned(kept('results share', 0.34));
