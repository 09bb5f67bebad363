// Pointer and keys of the scene: the point on the ground, clicks for tools, keys for views.

import { Vector3 } from 'three';
import { sendJson } from '../api/client';
import type { Point3 } from '../api/types';
import { notify } from '../state/messages';
import { model } from '../project/model';
import { Drag, dragOf, followPointer, handleAt, type DragView } from '../drag/drag';
import { openMenu } from '../drag/menu';
import { thingAt } from '../drag/things';
import type { Pixel } from '../geometry/nearness';
import type { ModelScene } from './modelScene';
import { namedViews, type NamedView } from './namedViews';
import * as picture from './picture';
import { finishTool, gripAt, inTurn, tool, type Place } from '../tools/tool';

const drag = 4; // pixels of movement that turn a click into a drag

export class Pointing {
  private down: { x: number; y: number } | null = null;
  private last: PointerEvent | null = null;
  private waiting = 0;
  private isRefining = false;
  /// Called for clicks without a tool.
  onClick: (event: PointerEvent) => void = () => {};
  /// The rock of the trajectory at a place of the window; null: none.
  rockAt: (x: number, y: number) => number | null = () => null;
  private readonly listening = new AbortController();
  /// A press of the right button, until it moves the view.
  private right: { x: number; y: number } | null = null;

  constructor(private readonly scene: ModelScene) {
    const canvas = scene.stage.renderer.domElement;
    const on = <K extends keyof HTMLElementEventMap>(type: K, task: (event: HTMLElementEventMap[K]) => void) =>
      canvas.addEventListener(type, task, { signal: this.listening.signal });
    // Before the controls of the view see it.
    scene.stage.host.addEventListener('pointerdown', (event) => this.press(event), { capture: true, signal: this.listening.signal });
    on('contextmenu', (event) => {
      event.preventDefault();
      if (event.button !== 2) this.menuByKey(); // of the keyboard
    });
    on('pointerdown', (event) => {
      canvas.focus({ preventScroll: true });
      this.right = event.button === 2 ? { x: event.clientX, y: event.clientY } : null;
      this.down = event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
    });
    on('pointerup', (event) => {
      const { right } = this;
      this.right = null;
      if (right && event.button === 2 && Math.hypot(event.clientX - right.x, event.clientY - right.y) < drag) {
        if (!tool.value) this.menu(this.pixelOf(event), { x: event.clientX, y: event.clientY });
        return;
      }
      const still = this.down && Math.hypot(event.clientX - this.down.x, event.clientY - this.down.y) < drag;
      this.down = null;
      if (still) void inTurn(() => this.click(event));
    });
    on('pointermove', (event) => {
      this.last = event;
      if (event.buttons === 0) this.waiting ||= requestAnimationFrame(() => this.move());
    });
    on('pointerleave', () => {
      this.last = null;
      picture.setPointer(null);
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

  private get box() {
    return this.scene.stage.renderer.domElement.getBoundingClientRect();
  }
  private pixelOf(event: { clientX: number; clientY: number }): Pixel {
    const { left, top } = this.box;
    return [event.clientX - left, event.clientY - top];
  }
  private readonly view: DragView = {
    pixelOf: (point) => {
      const pixel = this.scene.stage.pixelOf(this.scene.local(point));
      return pixel && [pixel.x, pixel.y];
    },
    placeAt: ([x, y]) => {
      const { left, top } = this.box;
      return this.placeAt(left + x, top + y)?.point ?? null;
    },
    metresPerPixel: () => this.scene.stage.metresPerPixel,
  };

  private isOverHandle(event: PointerEvent): boolean {
    const at = this.pixelOf(event);
    return gripAt(this.view.pixelOf, at) !== null || handleAt(this.view, at) !== null;
  }

  thingAt = (event: PointerEvent) => thingAt(this.view, this.pixelOf(event));

  /// Takes a press on a handle away from the controls of the view.
  private press(event: PointerEvent) {
    if (event.button !== 0 || tool.value || event.target !== this.scene.stage.renderer.domElement) return;
    const at = this.pixelOf(event);
    const grip = gripAt(this.view.pixelOf, at);
    const what = grip ? null : handleAt(this.view, at);
    if (!grip && !what) return;
    event.stopPropagation();
    this.scene.stage.renderer.domElement.focus({ preventScroll: true });
    followPointer(grip ? dragOf(this.view, grip) : new Drag(this.view, what!, at), event, (now) => this.pixelOf(now), (dragged, up) => {
      if (!dragged && up) void inTurn(() => this.click(up));
    });
  }

  private menu(at: Pixel, place: { x: number; y: number }) {
    openMenu(this.view, at, place, this.rockAt(place.x, place.y), (point) => [
      { title: 'Centre the view here', act: () => this.centre(this.scene.local(point)) },
    ]);
  }

  /// At the middle of the view.
  private menuByKey() {
    if (tool.value) return;
    const { left, top, width, height } = this.box;
    this.menu([width / 2, height / 2], { x: left + width / 2, y: top + height / 2 });
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
        if (picture.pointer.peek() === place) picture.setPointer(z === null ? null : { point: [x, y, z] });
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
    this.scene.stage.renderer.domElement.style.cursor = this.isOverHandle(this.last) ? 'move' : '';
    picture.setPointer(place);
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
