// The section on the card of its project.

import { thumbnailRatio, thumbnailSize } from '../view/thumbnail';
import { framedIn } from './framed';
import { drawPaths } from './pathLayer';
import { comparedToDraw, paint, pathsToDraw } from './picture';

export function sectionThumbnail(): HTMLCanvasElement | null {
  const seen = framedIn(thumbnailSize);
  if (!seen) return null;
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: seen.width * thumbnailRatio, height: seen.height * thumbnailRatio });
  const pen = canvas.getContext('2d')!;
  pen.setTransform(thumbnailRatio, 0, 0, thumbnailRatio, 0, 0);
  paint(pen, seen, () => drawPaths(pen, seen, pathsToDraw.peek(), comparedToDraw.peek()), []);
  return canvas;
}
