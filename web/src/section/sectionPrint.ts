// The section for print.

import { printRatio } from '../view/png';
import { pictureSize, type SheetPicture } from '../view/sheet';
import { inLight } from '../view/theme';
import { framedIn } from './framed';
import { drawPaths } from './pathLayer';
import { comparedToDraw, paint, pathsToDraw } from './picture';
import { sectionLegends } from './sectionLegends';

export function sectionPicture(): SheetPicture {
  const seen = framedIn(pictureSize);
  if (!seen) throw new Error('There is no section to save yet.');
  return inLight(() => {
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width: Math.round(seen.width * printRatio), height: Math.round(seen.height * printRatio) });
    const pen = canvas.getContext('2d', { willReadFrequently: true })!;
    pen.setTransform(printRatio, 0, 0, printRatio, 0, 0);
    paint(pen, seen, () => drawPaths(pen, seen, pathsToDraw.peek(), comparedToDraw.peek()), []);
    const isEqual = Math.abs(seen.up / seen.along - 1) < 1e-6;
    return {
      canvas,
      legends: sectionLegends(),
      metresPerPixel: isEqual ? 1 / seen.along : null,
      heading: null,
      remarks: [isEqual ? 'section, equal axes' : `section, vertical exaggeration ${(seen.up / seen.along).toPrecision(3)}`],
    };
  });
}
