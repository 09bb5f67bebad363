// A small picture of the open project, saved when it is closed, for its card on the start page.

import { api } from '../api/client';
import { writeInTurn } from '../state/writes';
import { file } from './document';
import { model } from './model';

let paintView: (() => Blob | null) | null = null;

/// A view that is open offers its picture, which is null if there is nothing to show. Returns a function that ends this.
export function offerThumbnail(paint: () => Blob | null): () => void {
  paintView = paint;
  return () => {
    if (paintView === paint) paintView = null;
  };
}

/// Saves the picture of the open project. A project without one has a card without one, so failures are not reported.
export function storeThumbnail() {
  const name = file.peek();
  if (name === null || model.peek() === null || !paintView) return;
  try {
    const picture = paintView();
    if (picture) void writeInTurn(() => api.keepPicture(name, picture)).catch(() => undefined);
  } catch {
    // The view lost its graphics.
  }
}
addEventListener('pagehide', storeThumbnail);
