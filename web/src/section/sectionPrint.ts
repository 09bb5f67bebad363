// The section for print.

import type { AnimatedView, Size } from '../animation/film';
import { printRatio } from '../figures/png';
import { pictureSize, type SheetPicture } from '../view/sheet';
import { inLight } from '../view/theme';
import type { Frame } from './frame';
import { framedIn } from './framed';
import { drawPaths } from './pathLayer';
import { comparedToDraw, paint, pathsToDraw } from './picture';
import { sectionLegends } from './sectionLegends';

/// The section in a picture of this size, with `ratio` pixels per CSS pixel.
function painted(seen: Frame, ratio: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: Math.round(seen.width * ratio), height: Math.round(seen.height * ratio) });
  const pen = canvas.getContext('2d', { willReadFrequently: true })!;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  paint(pen, seen, () => drawPaths(pen, seen, pathsToDraw.peek(), comparedToDraw.peek()), []);
  return canvas;
}

function seenIn(size: Size): Frame {
  const seen = framedIn(size);
  if (!seen) throw new Error('There is no section to save yet.');
  return seen;
}

export function sectionPicture(): SheetPicture {
  const seen = seenIn(pictureSize);
  return inLight(() => {
    const canvas = painted(seen, printRatio);
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

/// The section as the frames of an animation.
export const animatedSection: AnimatedView = { paint: (size) => inLight(() => painted(seenIn(size), 1)) };
