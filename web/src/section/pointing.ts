// Pointer and keys of the section: position, view, clicks for tools or on seeders and barriers.

import type { Point3 } from '../api/types';
import type { Drag, Place } from '../scene/tool';
import { dragging, endDrag, finishTool, gripAt, tool } from '../scene/tool';
import { model } from '../state/model';
import { chosen } from '../state/view';
import { moved, pixelOf, placeOf, zoomed } from './frame';
import { fit, frame } from './framed';
import { pointer } from './picture';
import { groundBelow, nearestSegment, profile } from './profile';
import { pathOf, type Path } from '../model/names';

const drag = 4; // pixels of movement that turn a click into a drag
const near = 12; // pixels within which a mark is picked

function placeAt(canvas: HTMLCanvasElement, event: MouseEvent): { x: number; z: number } | null {
  if (!frame.value) return null;
  const box = canvas.getBoundingClientRect();
  const [x, z] = placeOf(frame.value, event.clientX - box.left, event.clientY - box.top);
  return { x, z };
}

/// The point with its segment: the nearest one, or the one below the pointer.
function withSegment({ x, z }: { x: number; z: number }): Place {
  const now = profile.value;
  if (!now || !frame.value) return { point: [x, 0, z] };
  const found = nearestSegment(now, x, z, frame.value.up / frame.value.along);
  const facet = found.distance * frame.value.along <= near ? found.segment : groundBelow(now, x)?.segment;
  return { point: [x, 0, z], ...(facet !== undefined && { facet }) };
}

/// The path of the seeder or barrier at a point; null if there is none.
function thingAt({ x, z }: { x: number; z: number }): Path | null {
  const [now, view] = [model.value, frame.value];
  if (!now || !view) return null;
  const [left, top] = pixelOf(view, x, z);
  const distanceTo = ([px, , pz]: [number, number, number]) => {
    const [a, b] = pixelOf(view, px, pz);
    return Math.hypot(a - left, b - top);
  };
  const seeder = now.seeders.find(({ points }) => points.some((point) => distanceTo(point) < near));
  if (seeder) return pathOf(seeder.path);
  const barrier = now.barriers.find(({ foot, top: high }) => {
    const [a, b] = [foot[0], high[0]];
    if (!a || !b) return false;
    const middles = [0, 0.25, 0.5, 0.75, 1].map((s): [number, number, number] => [
      a[0] + s * (b[0] - a[0]),
      0,
      a[2] + s * (b[2] - a[2]),
    ]);
    return middles.some((point) => distanceTo(point) < near);
  });
  return barrier ? pathOf(barrier.path) : null;
}

/// The drag that would begin at the pointer.
function gripUnder(canvas: HTMLCanvasElement, event: PointerEvent): Drag | null {
  const now = frame.value;
  const box = canvas.getBoundingClientRect();
  return now && gripAt(([x, , z]: Point3) => pixelOf(now, x, z), [event.clientX - box.left, event.clientY - box.top]);
}

/// `onClick` is called for clicks without a tool that hit no seeder or barrier.
export function listen(canvas: HTMLCanvasElement, onClick: (event: PointerEvent) => void): () => void {
  const listening = new AbortController();
  const on = <K extends keyof HTMLElementEventMap>(type: K, task: (event: HTMLElementEventMap[K]) => void) =>
    canvas.addEventListener(type, task, { signal: listening.signal, passive: false });
  let down: { x: number; y: number; still: boolean } | null = null;
  let grabbed: PointerEvent | null = null; // until what it grabbed is moved

  on('pointerdown', (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    dragging.value = event.button === 0 ? gripUnder(canvas, event) : null;
    grabbed = dragging.value ? event : null;
    down = dragging.value ? null : { x: event.clientX, y: event.clientY, still: true };
  });
  on('pointermove', (event) => {
    if (down && frame.value) {
      const [dx, dy] = [event.clientX - down.x, event.clientY - down.y];
      if (down.still && Math.hypot(dx, dy) < drag) return;
      frame.value = moved(frame.value, dx, dy);
      down = { x: event.clientX, y: event.clientY, still: false };
      return;
    }
    const place = placeAt(canvas, event);
    if (!place) return;
    const ground = profile.value ? groundBelow(profile.value, place.x) : null;
    pointer.value = { ...place, ground: ground?.z ?? null };
    canvas.style.cursor = dragging.peek() ? 'grabbing' : gripUnder(canvas, event) ? 'grab' : '';
    if (grabbed && Math.hypot(event.clientX - grabbed.clientX, event.clientY - grabbed.clientY) < drag) return;
    grabbed = null;
    dragging.peek()?.move(withSegment(place));
    tool.value?.move?.(withSegment(place));
  });
  on('pointercancel', () => endDrag('cancel'));
  on('pointerup', (event) => {
    grabbed = null;
    if (dragging.peek()) return endDrag('drop');
    const wasClick = down?.still && event.button === 0;
    down = null;
    const place = placeAt(canvas, event);
    if (!wasClick || !place) return;
    if (tool.value) return tool.value.click(withSegment(place), { shift: event.shiftKey, ctrl: event.ctrlKey });
    const thing = thingAt(place);
    if (thing) chosen.value = thing;
    else onClick(event);
  });
  on('pointerleave', () => {
    pointer.value = null;
    tool.value?.move?.(null);
  });
  on('dblclick', finishTool);
  on('wheel', (event) => {
    event.preventDefault();
    const box = canvas.getBoundingClientRect();
    if (frame.value)
      frame.value = zoomed(frame.value, Math.exp(-0.0015 * event.deltaY), event.clientX - box.left, event.clientY - box.top);
  });
  on('keydown', (event) => {
    const now = frame.value;
    if (!now || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 60;
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [step, 0],
      ArrowRight: [-step, 0],
      ArrowUp: [0, step],
      ArrowDown: [0, -step],
    };
    const arrow = arrows[event.key];
    if (arrow) frame.value = moved(now, ...arrow);
    else if (event.key === '+' || event.key === '=') frame.value = zoomed(now, 1.25, now.width / 2, now.height / 2);
    else if (event.key === '-') frame.value = zoomed(now, 0.8, now.width / 2, now.height / 2);
    else if (event.key === '0') fit();
    else if (event.key === 'Enter' && tool.value) finishTool();
    else return;
    event.preventDefault();
  });
  return () => listening.abort();
}
