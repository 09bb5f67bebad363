// Pointer and keys of the scene: the point on the ground, clicks for tools, keys for views.

import { Vector3 } from 'three';
import { sendJson } from '../api/client';
import type { Point3 } from '../api/types';
import { notify } from '../state/messages';
import { model } from '../state/model';
import type { Pixel } from '../view/nearness';
import type { ModelScene } from './modelScene';
import { namedViews, type NamedView } from './namedViews';
import * as picture from './picture';
import { dragging, endDrag, finishTool, gripAt, inTurn, tool, type Drag, type Place } from './tool';

const drag = 4; // pixels of movement that turn a click into a drag

export class Pointing {
  private down: { x: number; y: number } | null = null;
  /// Where something was grabbed, until it is moved.
  private grabbed: { x: number; y: number } | null = null;
  private last: PointerEvent | null = null;
  private waiting = 0;
  private isRefining = false;
  /// Called for clicks without a tool.
  onClick: (event: PointerEvent) => void = () => {};
  private readonly listening = new AbortController();

  constructor(private readonly scene: ModelScene) {
    const canvas = scene.stage.renderer.domElement;
    const on = <K extends keyof HTMLElementEventMap>(type: K, task: (event: HTMLElementEventMap[K]) => void) =>
      canvas.addEventListener(type, task, { signal: this.listening.signal });
    // Before the controls of the camera, which would turn the view.
    canvas.addEventListener('pointerdown', (event) => this.grab(event), { capture: true, signal: this.listening.signal });
    on('pointerdown', (event) => {
      canvas.focus({ preventScroll: true });
      this.down = event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
    });
    on('pointercancel', () => endDrag('cancel'));
    on('pointerup', (event) => {
      if (dragging.peek()) return this.drop(event);
      const still = this.down && Math.hypot(event.clientX - this.down.x, event.clientY - this.down.y) < drag;
      this.down = null;
      if (still) void inTurn(() => this.click(event));
    });
    on('pointermove', (event) => {
      this.last = event;
      if (event.buttons === 0 || dragging.peek()) this.waiting ||= requestAnimationFrame(() => this.move());
    });
    on('pointerleave', () => {
      this.last = null;
      picture.pointer.value = null;
      tool.value?.move?.(null);
    });
    on('dblclick', (event) => {
      if (tool.value) return finishTool();
      // The clicked point becomes the centre of rotation.
      const place = this.placeAt(event.clientX, event.clientY);
      if (place) this.centre(scene.local(place.point));
    });
    on('keydown', (event) => this.key(event));
  }

  /// The drag that would begin at a position of the window.
  private gripAt({ clientX, clientY }: PointerEvent): Drag | null {
    const box = this.scene.stage.renderer.domElement.getBoundingClientRect();
    const pixelOf = (point: Point3): Pixel | null => {
      const at = this.scene.stage.pixelOf(this.scene.local(point));
      return at && [at.x, at.y];
    };
    return gripAt(pixelOf, [clientX - box.left, clientY - box.top]);
  }

  private grab(event: PointerEvent) {
    if (event.button !== 0) return;
    const drag = this.gripAt(event);
    if (!drag) return;
    event.stopImmediatePropagation();
    const canvas = this.scene.stage.renderer.domElement;
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    this.grabbed = { x: event.clientX, y: event.clientY };
    dragging.value = drag;
  }

  /// Moves what is dragged, once the pointer has left the place where it was grabbed.
  private drag({ clientX, clientY }: PointerEvent, place: Place | null) {
    const { grabbed } = this;
    if (grabbed && Math.hypot(clientX - grabbed.x, clientY - grabbed.y) < drag) return;
    this.grabbed = null;
    if (place) dragging.peek()?.move(place);
  }

  /// Ends a drag at the pointer, even if the last movement was not shown yet.
  private drop(event: PointerEvent) {
    this.drag(event, this.placeAt(event.clientX, event.clientY));
    endDrag('drop');
  }

  placeAt(x: number, y: number): Place | null {
    const hit = this.scene.terrain?.pick(this.scene.stage.ray(x, y));
    if (!hit) return null;
    const { facet, isCoarse } = hit;
    return { point: this.scene.frame.project(hit.point), ...(facet !== undefined && { facet }), ...(isCoarse && { isCoarse }) };
  }

  /// The engine's elevation; null where there is no terrain.
  private async elevation([x, y]: Point3): Promise<number | null> {
    const answer = await sendJson<{ z: (number | null)[] }>('POST', `/api/models/${model.peek()?.id}/elevations`, { points: [[x, y]] });
    return answer.z[0] ?? null;
  }

  /// Requests the exact elevation under the pointer if the drawn one is approximate; one request at a time.
  private async refine() {
    if (this.isRefining) return;
    this.isRefining = true;
    try {
      for (let place = picture.pointer.peek(); place?.isCoarse; place = picture.pointer.peek()) {
        const [x, y] = place.point;
        const z = await this.elevation(place.point);
        if (picture.pointer.peek() === place) picture.pointer.value = z === null ? null : { point: [x, y, z] };
      }
    } catch {
      // It stays approximate and is shown as such.
    } finally {
      this.isRefining = false;
    }
  }

  private move() {
    this.waiting = 0;
    if (!this.last) return;
    const place = this.placeAt(this.last.clientX, this.last.clientY);
    picture.pointer.value = place;
    const { style } = this.scene.stage.renderer.domElement;
    style.cursor = dragging.peek() ? 'grabbing' : this.gripAt(this.last) ? 'grab' : '';
    if (dragging.peek()) this.drag(this.last, place);
    tool.value?.move?.(place);
    void this.refine();
  }

  private async click(event: PointerEvent) {
    if (!tool.value) return this.onClick(event);
    const place = this.placeAt(event.clientX, event.clientY);
    if (!place) return notify('note', 'There is no terrain at this point.');
    const [used, { shiftKey: shift, ctrlKey: ctrl }] = [tool.value, event];
    // A raster may be drawn at lower resolution, so the engine's elevation is used.
    if (model.value?.kind === 'raster') {
      const z = await this.elevation(place.point);
      if (z !== null) place.point[2] = z;
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
    this.scene.stage.dolly(factor);
    this.scene.stage.invalidate();
  }

  private key(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const named = (Object.keys(namedViews) as NamedView[]).find((name) => namedViews[name].key === event.key);
    if (named) this.scene.view(named);
    else if (event.key === '+' || event.key === '=') this.zoom(0.8);
    else if (event.key === '-') this.zoom(1.25);
    else if (event.key === 'Enter' && tool.value) finishTool();
    else return;
    event.preventDefault();
  }

  dispose() {
    cancelAnimationFrame(this.waiting);
    this.listening.abort();
  }
}
