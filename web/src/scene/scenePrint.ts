// The scene for print.

import type { AnimatedView, Size } from '../animation/film';
import { shownMap } from '../maps/shownMap';
import { numberText } from '../units/numbers';
import { printRatio } from '../figures/png';
import { exaggeration } from '../view/settings';
import { pictureSize, type SheetPicture } from '../view/sheet';
import { inLight } from '../view/theme';
import type { ModelScene } from './modelScene';
import { drawNames } from './nameLayer';
import * as picture from './picture';
import { sceneCamera } from '../view/sceneCamera';
import { sceneLegends } from './SceneLegend';

const timeout = 6000; // ms to load terrain at the resolution of the print

const wait = (time: number) => new Promise((done) => setTimeout(done, time));

/// Loads the terrain for a picture of this size, with `ratio` pixels per CSS pixel.
async function loadTerrain(scene: ModelScene, size: Size, ratio: number, isFitted = false) {
  const until = performance.now() + timeout;
  while (performance.now() < until && scene.inSize(size, () => scene.missing(size.height * ratio), isFitted) > 0) await wait(100);
}

/// The view at the present size, with names.
function copied(scene: ModelScene, ratio: number): HTMLCanvasElement {
  const canvas = scene.stage.copy(ratio);
  const pen = canvas.getContext('2d')!;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawNames(pen, scene.stage, scene.names(), []);
  return canvas;
}

function paint(scene: ModelScene, isFitted: boolean): SheetPicture {
  const paintIn = () => {
    const canvas = copied(scene, printRatio);
    const { metresPerPixel, heading } = sceneCamera.peek();
    const interval = picture.contourInterval.peek();
    const remarks = [
      'scale at the centre of the view',
      ...(interval > 0 ? [`contour interval ${numberText(interval)} m`] : []),
      ...(exaggeration.peek() !== 1 ? [`vertical exaggeration ${exaggeration.peek()}`] : []),
      ...(shownMap.peek() ? [`map of ${shownMap.peek()!.meaning}`] : []),
    ];
    return { canvas, legends: sceneLegends(), metresPerPixel, heading, remarks };
  };
  return scene.inSize(pictureSize, paintIn, isFitted);
}

export async function scenePicture(scene: ModelScene, mustShowPlace: boolean): Promise<SheetPicture> {
  const isFitted = mustShowPlace && !scene.inSize(pictureSize, () => scene.showsPlaces());
  await loadTerrain(scene, pictureSize, printRatio, isFitted);
  try {
    return inLight(() => paint(scene, isFitted));
  } finally {
    scene.stage.invalidate();
  }
}

/// The scene as the frames of an animation.
export const animatedScene = (scene: ModelScene): AnimatedView => ({
  prepare: (size) => loadTerrain(scene, size, 1),
  paint(size) {
    const frame = inLight(() => scene.inSize(size, () => copied(scene, 1)));
    scene.stage.draw(); // the view behind the dialog, whose picture was used
    return frame;
  },
});
