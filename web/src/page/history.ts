// Addresses of the page, and Back and Forward of the browser between forms, tabs, runs, projects and the start page.

import { batch, effect } from '@preact/signals';
import { schema } from '../generated/schema';
import type { Path, TableName } from '../settings/names';
import { afterTyping } from '../project/typing';
import { camera, wantCamera, wantedCamera } from '../view/camera';
import { addressOf, isStep, placeOf, type Place } from './address';
import { file, fileStem, rowsOf, values } from '../project/document';
import { reportFailure } from '../state/messages';
import { close, open } from '../project/opening';
import { comparedId, shownId, showRuns } from '../runs/runs';
import { resultsTab, showTab, sidePanel, turnToPanel } from '../state/panels';
import { askedText, isAsking, openAsked } from '../askLine/asked';
import { drape, drapedMap } from '../maps/shownMap';
import { chosen, turnTo } from '../project/chosen';
import { chooseRock, chosenRock } from '../runs/chosenRock';
import { showVerification, verifying } from '../start/verifying';
import { allWritten } from '../state/writes';

const pause = 300; // ms, from the last movement of the view to its address

function placeNow(): Place {
  const now = file.value;
  return {
    file: now,
    verifying: now === null && verifying.value,
    chosen: now === null ? null : chosen.value,
    sidePanel: sidePanel.value,
    resultsTab: resultsTab.value,
    run: shownId.value,
    compared: comparedId.value,
    rock: chosenRock.value,
    map: drapedMap.value,
    asked: isAsking.value ? askedText.value : null,
    camera: wantedCamera.value ?? camera.value,
  };
}

const exists = (path: Path | null) =>
  path === null ||
  (String(path[0]) in schema.properties && (typeof path[1] !== 'number' || rowsOf(path[0] as TableName).length > path[1]));

async function goTo(place: Place, moves: boolean) {
  const isOpen = place.file === file.value;
  if (!isOpen) {
    if (file.value !== null) close();
    await allWritten(); // including the draft of the closed project, which may be the one to open
    if (place.file !== null) await open(place.file);
  }
  batch(() => {
    showVerification(place.verifying);
    turnToPanel(place.sidePanel);
    showTab(place.resultsTab);
    if (place.file === null) return;
    turnTo(exists(place.chosen) ? place.chosen : null);
    chooseRock(place.rock);
    drape(place.map);
    openAsked(place.asked);
    showRuns(place.run, place.compared);
    if (!isOpen || moves) wantCamera(place.camera);
  });
}

const placeInAddress = () => placeOf(location.hash, { sidePanel: sidePanel.peek(), resultsTab: resultsTab.peek() });

/// Goes where the address points. Returns false if that is the start page.
export async function goToAddress(): Promise<boolean> {
  const place = placeInAddress();
  if (place.file === null && !place.verifying) return false;
  await goTo(place, true);
  return true;
}

/// The address without its last part, for the start page.
const whole = (address: string) => address || location.pathname + location.search;
/// Marks the entries of the browser's history that this page made.
const ours = { talus: 1 };

/// Keeps the address and the browser's history, and follows Back, Forward and addresses that are typed.
export function listenToHistory(): () => void {
  let going = 0;
  let isDue = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let last = placeNow();
  const replace = () => {
    clearTimeout(timer);
    history.replaceState(ours, '', whole(addressOf(last)));
  };
  replace();
  // Changes in one task are one step.
  const record = () => {
    isDue = false;
    const [now, before] = [placeNow(), last];
    if (going > 0) return;
    last = now;
    if (isStep(before, now)) {
      clearTimeout(timer);
      history.pushState(ours, '', whole(addressOf(now)));
    } else if (addressOf(now) !== addressOf(before)) {
      clearTimeout(timer);
      timer = setTimeout(replace, pause); // browsers limit how often an address may change
    }
  };
  const ends = [
    effect(() => {
      placeNow();
      if (!isDue) queueMicrotask(record);
      isDue = true;
    }),
    effect(() => {
      const name = typeof values.value.name === 'string' ? values.value.name : fileStem();
      document.title = file.value === null ? 'Talus' : `${name} - Talus`;
    }),
  ];
  const go = ({ state }: PopStateEvent) => {
    clearTimeout(timer); // the address is that of another entry now
    const [place, isTyped] = [placeInAddress(), state === null];
    afterTyping(async () => {
      ++going;
      try {
        await goTo(place, isTyped);
      } catch (error) {
        reportFailure(error);
      } finally {
        // If it failed, the entry is the actual location.
        if (--going === 0) {
          last = placeNow();
          replace();
        }
      }
    });
  };
  addEventListener('popstate', go);
  return () => {
    clearTimeout(timer);
    ends.forEach((end) => end());
    removeEventListener('popstate', go);
  };
}
