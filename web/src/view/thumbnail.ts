// A small picture of the view, saved when a project is closed, for its card on the start page.

import { api } from '../api/client';
import { file } from '../project/document';
import { model } from '../project/model';
import { writeInTurn } from '../state/writes';
import { cssColour, inLight } from './theme';

/// In CSS pixels, as on a card.
export const thumbnailSize = { width: 288, height: 162 };
export const thumbnailRatio = 1.6;
const [type, quality] = ['image/webp', 0.8];

/// Paints the open view, of `thumbnailSize` at `thumbnailRatio`; null if there is nothing to show.
let paintView: (() => HTMLCanvasElement | null) | null = null;

/// A view that is open offers its picture. Returns a function that ends this.
export function offerThumbnail(paint: () => HTMLCanvasElement | null): () => void {
  paintView = paint;
  return () => {
    if (paintView === paint) paintView = null;
  };
}

function painted(): Blob | null {
  const canvas = document.createElement('canvas');
  const { width, height } = thumbnailSize;
  Object.assign(canvas, { width: Math.round(width * thumbnailRatio), height: Math.round(height * thumbnailRatio) });
  const pen = canvas.getContext('2d', { alpha: false })!;
  const isPainted = inLight(() => {
    const view = paintView?.();
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

/// Saves the picture of the open project. A project without one has a card without one, so failures are not reported.
export function storeThumbnail() {
  const name = file.peek();
  if (name === null || model.peek() === null || !paintView) return;
  try {
    const picture = painted();
    if (picture) void writeInTurn(() => api.keepPicture(name, picture)).catch(() => undefined);
  } catch {
    // The view lost its graphics.
  }
}
addEventListener('pagehide', storeThumbnail);
