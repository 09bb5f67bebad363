// The entry to all modules that use three.js, loaded when a scene is first shown.

import type { AnimatedView } from '../animation/film';
import { toggleRelease } from '../askLine/sources';
import { showHandles } from '../drag/handles';
import { choose, chosen } from '../project/chosen';
import { chosenRock, showRock } from '../runs/chosenRock';
import { LayerScene } from './layerScene';
import { memoryOf, type SceneMemory } from './memory';
import { ModelScene } from './modelScene';
import { ObservedScene } from './observedScene';
import { Pointing } from './pointing';
import { RunScene } from './runScene';
import { animatedScene, scenePicture } from './scenePrint';
import { SourceScene } from './sourceScene';
import { offerSheet } from '../view/sheet';
import { offerThumbnail } from '../project/thumbnail';
import { thumbnailOf } from '../view/thumbnail';
import { sceneThumbnail } from './sceneThumbnail';

export interface OpenScene {
  scene: ModelScene;
  pointing: Pointing;
  animated: AnimatedView;
  memory: () => SceneMemory;
  dispose(): void;
}

export function openScene(host: HTMLElement): OpenScene {
  const scene = new ModelScene(host);
  const pointing = new Pointing(scene);
  const runs = new RunScene(scene);
  const observed = new ObservedScene(scene);
  const sources = new SourceScene(scene);
  const layers = new LayerScene(scene);
  pointing.rockAt = (x, y) => runs.rockAt(x, y);
  // Without a tool, a click on a release place shows only its rocks. Otherwise it selects the rock of a trajectory, or else a
  // seeder or barrier; next to all it deselects.
  pointing.onClick = (event) => {
    const place = sources.placeAt(event.clientX, event.clientY);
    if (place !== null) return toggleRelease(place);
    showRock(runs.rockAt(event.clientX, event.clientY));
    if (chosenRock.value === null) choose(pointing.thingAt(event) ?? chosen.value);
  };
  const endHandles = showHandles();
  const endOffering = offerThumbnail(() => thumbnailOf(() => sceneThumbnail(scene)));
  const endSheet = offerSheet((mustShowPlace) => scenePicture(scene, mustShowPlace));
  return {
    scene,
    pointing,
    animated: animatedScene(scene),
    memory: () => memoryOf(scene.stage.world),
    dispose() {
      endOffering();
      endSheet();
      endHandles();
      pointing.dispose();
      runs.dispose();
      observed.dispose();
      sources.dispose();
      layers.dispose();
      scene.dispose();
    },
  };
}
