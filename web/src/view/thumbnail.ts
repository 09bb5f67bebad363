// The picture of a view for the card of its project.

import { cssColour, inLight } from './theme';

/// In CSS pixels, as on a card.
export const thumbnailSize = { width: 288, height: 162 };
export const thumbnailRatio = 1.6;
const [type, quality] = ['image/webp', 0.8];

/// The picture over the background of the views. `paintView` paints it, of `thumbnailSize` at `thumbnailRatio`; null if
/// there is nothing to show.
export function thumbnailOf(paintView: () => HTMLCanvasElement | null): Blob | null {
  const canvas = document.createElement('canvas');
  const { width, height } = thumbnailSize;
  Object.assign(canvas, { width: Math.round(width * thumbnailRatio), height: Math.round(height * thumbnailRatio) });
  const pen = canvas.getContext('2d', { alpha: false })!;
  const isPainted = inLight(() => {
    const view = paintView();
    if (!view) return false;
    const ground = pen.createLinearGradient(0, 0, 0, canvas.height);
    ground.addColorStop(0, cssColour('--scene-top'));
    ground.addColorStop(1, cssColour('--scene-bottom'));
    pen.fillStyle = ground;
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(view, 0, 0, canvas.width, canvas.height);
    return true;
  });
  if (!isPainted) return null;
  // Not toBlob(), which calls back only after the page has gone.
  const [head, data] = canvas.toDataURL(type, quality).split(',');
  if (!head?.startsWith(`data:${type}`) || data === undefined) return null;
  return new Blob([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))], { type });
}
