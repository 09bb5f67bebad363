// The scene for print.

import { shownMap } from '../maps/shownMap';
import { numberText } from '../ui/format';
import { printRatio } from '../view/png';
import { exaggeration } from '../view/settings';
import { pictureSize, type SheetPicture } from '../view/sheet';
import { inLight } from '../view/theme';
import type { ModelScene } from './modelScene';
import { drawNames } from './nameLayer';
import * as picture from './picture';
import { sceneLegends } from './SceneLegend';

const timeout = 6000; // ms to load terrain at the resolution of the print

const wait = (time: number) => new Promise((done) => setTimeout(done, time));

/// Loads the terrain at the resolution of the print.
async function loadTerrain(scene: ModelScene) {
  const until = performance.now() + timeout;
  const pixels = pictureSize.height * printRatio;
  while (performance.now() < until && scene.inSize(pictureSize, () => scene.missing(pixels)) > 0) await wait(100);
}

function paint(scene: ModelScene): SheetPicture {
  const { stage } = scene;
  return scene.inSize(pictureSize, () => {
    const canvas = stage.copy(printRatio);
    const pen = canvas.getContext('2d')!;
    pen.setTransform(printRatio, 0, 0, printRatio, 0, 0);
    drawNames(pen, stage, scene.names(), []);
    const { metresPerPixel, heading } = picture.camera.peek();
    const interval = picture.contourInterval.peek();
    const remarks = [
      'scale at the centre of the view',
      ...(interval > 0 ? [`contour interval ${numberText(interval)} m`] : []),
      ...(exaggeration.peek() !== 1 ? [`vertical exaggeration ${exaggeration.peek()}`] : []),
      ...(shownMap.peek() ? [`map ${shownMap.peek()!.name}`] : []),
    ];
    return { canvas, legends: sceneLegends(), metresPerPixel, heading, remarks };
  });
}

export async function scenePicture(scene: ModelScene): Promise<SheetPicture> {
  await loadTerrain(scene);
  try {
    return inLight(() => paint(scene));
  } finally {
    scene.stage.invalidate();
  }
}
