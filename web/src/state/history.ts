// Back and Forward of the browser, between forms, tabs, projects and the start page.

import { batch, effect } from '@preact/signals';
import { file, rowsOf } from './document';
import { reportFailure } from './messages';
import { close, open } from './opening';
import { chosen, isAsking, resultsTab, sidePanel, verifying, type ResultsTab, type SidePanel } from './view';
import { allWritten } from './writes';
import { afterTyping } from '../ui/typing';
import type { Path, TableName } from '../model/names';

/// A location in the workbench, as an entry of the browser's history.
interface Place {
  talus: 1;
  file: string | null;
  verifying: boolean;
  chosen: Path | null;
  sidePanel: SidePanel;
  resultsTab: ResultsTab;
  isAsking: boolean;
}

function placeNow(): Place {
  const now = file.value;
  return {
    talus: 1,
    file: now,
    verifying: now === null && verifying.value,
    chosen: now === null ? null : chosen.value,
    sidePanel: sidePanel.value,
    resultsTab: resultsTab.value,
    isAsking: now !== null && isAsking.value,
  };
}

const isPlace = (state: unknown): state is Place => (state as Place | null)?.talus === 1;
/// On the start page the open tabs do not matter.
function isSame(a: Place, b: Place): boolean {
  if (a.file === null && b.file === null) return a.verifying === b.verifying;
  return JSON.stringify(a) === JSON.stringify(b);
}

const exists = (path: Place['chosen']) =>
  path === null || typeof path[1] !== 'number' || rowsOf(path[0] as TableName).length > path[1];

async function goTo(place: Place) {
  if (place.file !== file.value) {
    if (file.value !== null) close();
    await allWritten(); // including the draft of the closed project, which may be the one to open
    if (place.file !== null) await open(place.file);
  }
  batch(() => {
    verifying.value = place.verifying;
    sidePanel.value = place.sidePanel;
    resultsTab.value = place.resultsTab;
    if (place.file !== null) isAsking.value = place.isAsking ?? false;
    chosen.value = place.file !== null && exists(place.chosen) ? place.chosen : null;
  });
}

/// Records where the user goes, and follows Back and Forward.
export function listenToHistory(): () => void {
  let going = 0;
  let isDue = false;
  history.replaceState(placeNow(), '');
  // Changes in one task are one step.
  const record = () => {
    isDue = false;
    const [now, last]: [Place, unknown] = [placeNow(), history.state];
    if (going > 0 || (isPlace(last) && isSame(now, last))) return;
    history.pushState(now, '');
  };
  const end = effect(() => {
    placeNow();
    if (!isDue) queueMicrotask(record);
    isDue = true;
  });
  const go = ({ state }: PopStateEvent) => {
    if (!isPlace(state)) return;
    afterTyping(async () => {
      ++going;
      try {
        await goTo(state);
      } catch (error) {
        reportFailure(error);
      } finally {
        // If it failed, the entry is the actual location.
        if (--going === 0) history.replaceState(placeNow(), '');
      }
    });
  };
  addEventListener('popstate', go);
  return () => {
    end();
    removeEventListener('popstate', go);
  };
}
