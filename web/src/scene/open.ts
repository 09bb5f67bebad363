// All that the scene needs of three.js, in one piece that is fetched when a scene is first shown.

import { chosenRock, resultsTab } from '../state/view';
import { ModelScene } from './modelScene';
import { Pointing } from './pointing';
import { RunScene } from './runScene';
import { scenePicture } from './scenePrint';
import type { SheetPicture } from '../view/sheet';

export interface OpenScene {
  scene: ModelScene;
  pointing: Pointing;
  /// For paper.
  picture: () => Promise<SheetPicture>;
  dispose(): void;
}

export function openScene(host: HTMLElement): OpenScene {
  const scene = new ModelScene(host);
  const pointing = new Pointing(scene);
  const runs = new RunScene(scene);
  // A click that no tool takes is for a path; one beside all of them is for none.
  pointing.onClick = ({ clientX, clientY }) => {
    chosenRock.value = runs.rockAt(clientX, clientY);
    if (chosenRock.value !== null) resultsTab.value = 'rock';
  };
  return {
    scene,
    pointing,
    picture: () => scenePicture(scene),
    dispose() {
      pointing.dispose();
      runs.dispose();
      scene.dispose();
    },
  };
}
