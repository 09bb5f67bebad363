// The scene on paper.

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

const patience = 6000; // ms for ground as fine as the print shows it

const wait = (time: number) => new Promise((done) => setTimeout(done, time));

/// Fetches the ground that the print shows.
async function fetchGround(scene: ModelScene) {
  const until = performance.now() + patience;
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
      'scale at the middle of the view',
      ...(interval > 0 ? [`contours every ${numberText(interval)} m`] : []),
      ...(exaggeration.peek() !== 1 ? [`heights times ${exaggeration.peek()}`] : []),
      ...(shownMap.peek() ? [`map ${shownMap.peek()!.name}`] : []),
    ];
    return { canvas, legends: sceneLegends(), metresPerPixel, heading, remarks };
  });
}

export async function scenePicture(scene: ModelScene): Promise<SheetPicture> {
  await fetchGround(scene);
  try {
    return inLight(() => paint(scene));
  } finally {
    scene.stage.invalidate();
  }
}
