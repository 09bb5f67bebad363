// How large and from where the scene shows the ground.

import { signal, type ReadonlySignal } from '@preact/signals';

interface SceneCamera {
  metresPerPixel: number;
  /// View direction in degrees from north, clockwise.
  heading: number;
}

const camera = signal<SceneCamera>({ metresPerPixel: 1, heading: 0 });
export const sceneCamera: ReadonlySignal<SceneCamera> = camera;
export const setSceneCamera = (next: SceneCamera) => void (camera.value = next);
