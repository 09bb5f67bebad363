// The entry to all modules that use three.js, loaded when a scene is first shown.

import type { AnimatedView } from '../animation/film';
import { chosenRock, resultsTab } from '../state/view';
import { toggleRelease } from '../askLine/sources';
import { ModelScene } from './modelScene';
import { ObservedScene } from './observedScene';
import { Pointing } from './pointing';
import { RunScene } from './runScene';
import { animatedScene, scenePicture } from './scenePrint';
import { SourceScene } from './sourceScene';
import type { SheetPicture } from '../view/sheet';

export interface OpenScene {
  scene: ModelScene;
  pointing: Pointing;
  /// The picture for print.
  picture: () => Promise<SheetPicture>;
  animated: AnimatedView;
  dispose(): void;
}

export function openScene(host: HTMLElement): OpenScene {
  const scene = new ModelScene(host);
  const pointing = new Pointing(scene);
  const runs = new RunScene(scene);
  const observed = new ObservedScene(scene);
  const sources = new SourceScene(scene);
  // A click on a release place shows only its rocks. Otherwise, without a tool, a click selects the rock of a trajectory; next to all trajectories it deselects.
  pointing.onClick = ({ clientX, clientY }) => {
    const place = sources.placeAt(clientX, clientY);
    if (place !== null) return toggleRelease(place);
    chosenRock.value = runs.rockAt(clientX, clientY);
    if (chosenRock.value !== null) resultsTab.value = 'rock';
  };
  return {
    scene,
    pointing,
    picture: () => scenePicture(scene),
    animated: animatedScene(scene),
    dispose() {
      pointing.dispose();
      runs.dispose();
      observed.dispose();
      sources.dispose();
      scene.dispose();
    },
  };
}
