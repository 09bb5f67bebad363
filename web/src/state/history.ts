// Back and Forward of the browser: from a form to the outline, from tab to tab, from a project to the start page.

import { batch, effect } from '@preact/signals';
import { file, rowsOf } from './document';
import { sayFailure } from './messages';
import { close, open } from './opening';
import { chosen, resultsTab, sidePanel, verifying, type ResultsTab, type SidePanel } from './view';
import { allWritten } from './writes';
import { taken } from '../ui/typing';
import type { Path, TableName } from '../model/names';

/// Where the user is, as an entry of the browser's history.
interface Place {
  talus: 1;
  file: string | null;
  verifying: boolean;
  chosen: Path | null;
  sidePanel: SidePanel;
  resultsTab: ResultsTab;
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
  };
}

const isPlace = (state: unknown): state is Place => (state as Place | null)?.talus === 1;
/// On the start page it is all the same which tabs were open.
function isSame(a: Place, b: Place): boolean {
  if (a.file === null && b.file === null) return a.verifying === b.verifying;
  return JSON.stringify(a) === JSON.stringify(b);
}

const isThere = (path: Place['chosen']) =>
  path === null || typeof path[1] !== 'number' || rowsOf(path[0] as TableName).length > path[1];

async function goTo(place: Place) {
  if (place.file !== file.value) {
    if (file.value !== null) close();
    await allWritten(); // the draft of what was left, which may be what is opened
    if (place.file !== null) await open(place.file);
  }
  batch(() => {
    verifying.value = place.verifying;
    sidePanel.value = place.sidePanel;
    resultsTab.value = place.resultsTab;
    chosen.value = place.file !== null && isThere(place.chosen) ? place.chosen : null;
  });
}

/// Follows where the user goes, and goes where the browser says.
export function listenToHistory(): () => void {
  let going = 0;
  let isDue = false;
  history.replaceState(placeNow(), '');
  // What changes in one go is one step.
  const note = () => {
    isDue = false;
    const [now, noted]: [Place, unknown] = [placeNow(), history.state];
    if (going > 0 || (isPlace(noted) && isSame(now, noted))) return;
    history.pushState(now, '');
  };
  const end = effect(() => {
    placeNow();
    if (!isDue) queueMicrotask(note);
    isDue = true;
  });
  const go = ({ state }: PopStateEvent) => {
    if (!isPlace(state)) return;
    taken(async () => {
      ++going;
      try {
        await goTo(state);
      } catch (error) {
        sayFailure(error);
      } finally {
        // Where it could not go, it is here.
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
