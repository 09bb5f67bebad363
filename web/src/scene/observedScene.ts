// Observed stops and marks in the scene.

import { effect, signal } from '@preact/signals';
import { Group } from 'three';
import { shownObserved } from '../calibration/observations';
import { markColours } from '../view/colours';
import { clear, dots } from './marks';
import type { ModelScene } from './modelScene';

export class ObservedScene {
  private readonly group = new Group();
  /// Incremented when the frame of the terrain changes, because positions are relative to it.
  private readonly terrain = signal(0);
  private readonly end: () => void;

  constructor(scene: ModelScene) {
    scene.add(this.group);
    scene.onTerrain.push(() => (this.terrain.value = this.terrain.peek() + 1));
    this.end = effect(() => {
      void this.terrain.value;
      clear(this.group);
      for (const { kind, places } of shownObserved.value) {
        if (places.length === 0) continue;
        const shape = kind === 'stops' ? 'diamond' : 'cross';
        const drawn = dots(places.map(scene.local), { colour: markColours[kind], size: 16, shape });
        drawn.renderOrder = 12; // over the simulated end points
        this.group.add(drawn);
      }
      scene.stage.invalidate();
    });
  }

  dispose() {
    this.end();
    clear(this.group);
  }
}
