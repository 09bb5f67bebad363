// How large and from where the scene shows the ground.

import { signal } from '@preact/signals';
import { owned } from '../state/owned';

interface SceneCamera {
  metresPerPixel: number;
  /// View direction in degrees from north, clockwise.
  heading: number;
}

export const [sceneCamera, setSceneCamera] = owned(signal<SceneCamera>({ metresPerPixel: 1, heading: 0 }));
