// Pointer and keys of the section: position, view, clicks for tools or on seeders and barriers.

import { Drag, dragOf, followPointer, handleAt, type DragView } from '../drag/drag';
import { showHandles } from '../drag/handles';
import { openMenu } from '../drag/menu';
import { thingAt } from '../drag/things';
import type { Place } from '../tools/tool';
import { finishTool, gripAt, tool } from '../tools/tool';
import { choose } from '../project/chosen';
import type { Pixel } from '../geometry/nearness';
import { pixelOf, placeOf } from './frame';
import { fit, frame, moveBy, zoomBy } from './framed';
import { setPointer } from './picture';
import { groundBelow, nearestSegment, profile } from '../project/profile';

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

const view: DragView = {
  pixelOf: ([x, , z]) => frame.value && pixelOf(frame.value, x, z),
  placeAt: ([left, top]) => {
    if (!frame.value) return null;
    const [x, z] = placeOf(frame.value, left, top);
    return [x, 0, z];
  },
  metresPerPixel: () => (frame.value ? 1 / frame.value.along : 1),
};

/// `onClick` is called for clicks without a tool that hit no seeder or barrier. `rockOf`: the rock of the trajectory at an
/// event; null: none.
export function listen(canvas: HTMLCanvasElement, onClick: (event: MouseEvent) => void, rockOf: (event: MouseEvent) => number | null): () => void {
  const listening = new AbortController();
  const on = <K extends keyof HTMLElementEventMap>(type: K, task: (event: HTMLElementEventMap[K]) => void) =>
    canvas.addEventListener(type, task, { signal: listening.signal, passive: false });
  let down: { x: number; y: number; still: boolean } | null = null;

  const at = (event: MouseEvent): Pixel => {
    const { left, top } = canvas.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const click = (event: MouseEvent) => {
    const thing = thingAt(view, at(event));
    if (thing) choose(thing);
    else onClick(event);
  };
  const endHandles = showHandles();
  on('contextmenu', (event) => {
    event.preventDefault();
    if (tool.value || event.button === 2) return;
    const { left, top, width, height } = canvas.getBoundingClientRect(); // of the keyboard: at the middle
    openMenu(view, [width / 2, height / 2], { x: left + width / 2, y: top + height / 2 }, null);
  });
  on('pointerdown', (event) => {
    canvas.focus({ preventScroll: true });
    const isFree = event.button === 0 && !tool.value;
    const grip = isFree ? gripAt(view.pixelOf, at(event)) : null;
    const what = isFree && !grip ? handleAt(view, at(event)) : null;
    if (grip || what) {
      followPointer(grip ? dragOf(view, grip) : new Drag(view, what!, at(event)), event, at, (dragged, up) => {
        if (!dragged && up) click(up);
      });
      return;
    }
    canvas.setPointerCapture(event.pointerId);
    down = { x: event.clientX, y: event.clientY, still: true };
  });
  on('pointermove', (event) => {
    if (down && frame.value) {
      const [dx, dy] = [event.clientX - down.x, event.clientY - down.y];
      if (down.still && Math.hypot(dx, dy) < drag) return;
      moveBy(dx, dy);
      down = { x: event.clientX, y: event.clientY, still: false };
      return;
    }
    const place = placeAt(canvas, event);
    if (!place) return;
    const isOverHandle = gripAt(view.pixelOf, at(event)) ?? handleAt(view, at(event));
    canvas.style.cursor = !tool.value && isOverHandle ? 'move' : '';
    const ground = profile.value ? groundBelow(profile.value, place.x) : null;
    setPointer({ ...place, ground: ground?.z ?? null });
    tool.value?.move?.(withSegment(place));
  });
  on('pointerup', (event) => {
    const wasClick = down?.still && event.button === 0;
    if (down?.still && event.button === 2 && !tool.value)
      openMenu(view, at(event), { x: event.clientX, y: event.clientY }, rockOf(event));
    down = null;
    const place = placeAt(canvas, event);
    if (!wasClick || !place) return;
    if (tool.value) return tool.value.click(withSegment(place), { shift: event.shiftKey, ctrl: event.ctrlKey });
    click(event);
  });
  on('pointerleave', () => {
    setPointer(null);
    tool.value?.move?.(null);
  });
  on('dblclick', finishTool);
  on('wheel', (event) => {
    event.preventDefault();
    const box = canvas.getBoundingClientRect();
    zoomBy(Math.exp(-0.0015 * event.deltaY), { x: event.clientX - box.left, y: event.clientY - box.top });
  });
  on('keydown', (event) => {
    if (!frame.value || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 60;
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [step, 0],
      ArrowRight: [-step, 0],
      ArrowUp: [0, step],
      ArrowDown: [0, -step],
    };
    const arrow = arrows[event.key];
    if (arrow) moveBy(...arrow);
    else if (event.key === '+' || event.key === '=') zoomBy(1.25);
    else if (event.key === '-') zoomBy(0.8);
    else if (event.key === '0') fit();
    else if (event.key === 'Enter' && tool.value) finishTool();
    else return;
    event.preventDefault();
  });
  return () => {
    listening.abort();
    endHandles();
  };
}
