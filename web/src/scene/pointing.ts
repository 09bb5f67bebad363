// The pointer and the keys over the picture: where it is on the ground, clicks for the tool, keys for the view.

import { Vector3 } from 'three';
import { sendJson } from '../api/client';
import { sayFailure } from '../state/messages';
import { model } from '../state/model';
import type { ModelScene } from './modelScene';
import { namedViews, type NamedView } from './namedViews';
import * as picture from './picture';
import { tool, type Place } from './tool';

const drag = 4; // pixels that make a click a drag

export class Pointing {
  private down: { x: number; y: number } | null = null;
  private last: PointerEvent | null = null;
  private waiting = 0;
  /// The clicks that are still being answered, in their order.
  private busy: Promise<void> = Promise.resolve();
  /// A click that no tool took.
  onClick: (event: PointerEvent) => void = () => {};
  private readonly listening = new AbortController();

  constructor(private readonly scene: ModelScene) {
    const canvas = scene.stage.renderer.domElement;
    const on = <K extends keyof HTMLElementEventMap>(type: K, task: (event: HTMLElementEventMap[K]) => void) =>
      canvas.addEventListener(type, task, { signal: this.listening.signal });
    on('pointerdown', (event) => {
      canvas.focus({ preventScroll: true });
      this.down = event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
    });
    on('pointerup', (event) => {
      const still = this.down && Math.hypot(event.clientX - this.down.x, event.clientY - this.down.y) < drag;
      this.down = null;
      if (still) this.busy = this.busy.then(() => this.click(event)).catch(sayFailure);
    });
    on('pointermove', (event) => {
      this.last = event;
      if (event.buttons === 0) this.waiting ||= requestAnimationFrame(() => this.move());
    });
    on('pointerleave', () => {
      this.last = null;
      picture.pointer.value = null;
      tool.value?.move?.(null);
    });
    on('dblclick', (event) => {
      // After the clicks that it is made of, which may wait for the engine.
      if (tool.value) return void this.busy.then(() => tool.value?.finish?.());
      // The view turns around the place that was meant.
      const place = this.placeAt(event.clientX, event.clientY);
      if (place) this.centre(scene.local(place.point));
    });
    on('keydown', (event) => this.key(event));
  }

  placeAt(x: number, y: number): Place | null {
    const hit = this.scene.terrain?.pick(this.scene.stage.ray(x, y));
    if (!hit) return null;
    return { point: this.scene.frame.project(hit.point), ...(hit.facet !== undefined && { facet: hit.facet }) };
  }

  private move() {
    this.waiting = 0;
    if (!this.last) return;
    const place = this.placeAt(this.last.clientX, this.last.clientY);
    picture.pointer.value = place;
    tool.value?.move?.(place);
  }

  private async click(event: PointerEvent) {
    if (!tool.value) return this.onClick(event);
    const place = this.placeAt(event.clientX, event.clientY);
    if (!place) return;
    const [used, { shiftKey: shift, ctrlKey: ctrl }] = [tool.value, event];
    // A raster may be drawn coarser than it is: the height is the engine's.
    if (model.value?.kind === 'raster') {
      const [x, y] = place.point;
      const answer = await sendJson<{ z: (number | null)[] }>('POST', `/api/models/${model.value.id}/elevations`, { points: [[x, y]] });
      if (typeof answer.z[0] === 'number') place.point = [x, y, answer.z[0]];
    }
    if (tool.value === used) used.click(place, { shift, ctrl });
  }

  private centre(local: Vector3) {
    const { stage } = this.scene;
    local.z *= stage.world.scale.z;
    const step = local.sub(stage.controls.target);
    stage.controls.target.add(step);
    stage.camera.position.add(step);
    stage.invalidate();
  }

  zoom(factor: number) {
    const { camera, controls } = this.scene.stage;
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    this.scene.stage.invalidate();
  }

  private key(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const named = (Object.keys(namedViews) as NamedView[]).find((name) => namedViews[name].key === event.key);
    if (named) this.scene.view(named);
    else if (event.key === '+' || event.key === '=') this.zoom(0.8);
    else if (event.key === '-') this.zoom(1.25);
    else if (event.key === 'Enter' && tool.value) tool.value.finish?.();
    else return;
    event.preventDefault();
  }

  dispose() {
    cancelAnimationFrame(this.waiting);
    this.listening.abort();
  }
}
