// The scene on the card of its project.

import { thumbnailRatio, thumbnailSize } from '../view/thumbnail';
import type { ModelScene } from './modelScene';

export function sceneThumbnail(scene: ModelScene): HTMLCanvasElement | null {
  if (!scene.terrain) return null;
  try {
    return scene.inSize(thumbnailSize, () => scene.stage.copy(thumbnailRatio));
  } finally {
    scene.stage.invalidate();
  }
}
