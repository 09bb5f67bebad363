// The visible part of the section: all of it, in the free part of the picture, until the user moves it.

import { computed, effect, signal, untracked, type ReadonlySignal } from '@preact/signals';
import { model } from '../project/model';
import { alongLine, bestBox, type Box } from '../geometry/framing';
import { cameraNumbers, cameraText, tellCamera, wantCamera, wantedCamera } from '../view/camera';
import { watchOver } from '../view/over';
import { equalAxes } from '../view/settings';
import { tool } from '../tools/tool';
import { fitted, moved, pixelOf, zoomed, type Bounds, type Frame } from './frame';
import { profile } from '../project/profile';

const current = signal<Frame | null>(null);
/// Null until the picture has a size and content.
export const frame: ReadonlySignal<Frame | null> = current;
/// Boxes of the page over the picture.
export const over = signal<Box[]>([]);

/// The area for names and the slope, inside the numbers of the axes.
export const roomOf = ({ width, height }: Pick<Frame, 'width' | 'height'>): Box => ({
  left: 46,
  top: 8,
  right: Math.max(width - 12, 66),
  bottom: Math.max(height - 50, 28),
});
/// What a section shows before it has vertices: a hundred metres of a slope that begins at the lower left [m].
function emptyFrame(size: { width: number; height: number }): Frame {
  const [across, margin] = [120, 10];
  const scale = size.width / across;
  return { ...size, x: across / 2 - margin, z: size.height / scale / 2 - margin, along: scale, up: scale };
}

const nameHeight = 22; // of a name above the highest mark

/// The bounds of the slope with its seeders and barriers.
const bounds = computed<Bounds | null>(() => {
  const places = (profile.value?.vertices ?? []).map(([x, z]) => ({ x, z }));
  const now = model.value;
  if (places.length === 0 || !now) return null;
  for (const [x, , z] of [...now.seeders.flatMap(({ points }) => points), ...now.barriers.flatMap(({ top }) => top)])
    places.push({ x, z });
  const range = (values: number[]): [number, number] => [
    values.reduce((a, b) => Math.min(a, b)),
    values.reduce((a, b) => Math.max(a, b)),
  ];
  return { x: range(places.map(({ x }) => x)), z: range(places.map(({ z }) => z)) };
});

/// The frame that shows the whole section in a picture of this size, outside `boxes`.
export function wholeSection(size: { width: number; height: number }, room: Box, boxes: readonly Box[]): Frame | null {
  const all = bounds.value;
  if (!all) return null;
  const standing = (model.value?.barriers ?? []).flatMap(({ foot, top }) => (foot[0] && top[0] ? [[foot[0], top[0]]] : []));
  const place = (box: Box) => {
    const made = fitted(all, size, { ...box, top: Math.min(box.top + nameHeight, box.bottom - 10) }, equalAxes.value);
    const lines = [(profile.value?.vertices ?? []).map(([x, z]) => pixelOf(made, x, z)), ...standing.map((ends) => ends.map(([x, , z]) => pixelOf(made, x, z)))];
    return { size: Math.sqrt(made.along * made.up), points: lines.flatMap((line) => [...alongLine(line)]), made };
  };
  return bestBox(room, boxes, place)?.made ?? null;
}

// The last fitted frame. While it is the current frame, the user has not moved it.
let fittedLast: Frame | null = null;

export function fit() {
  const now = frame.peek();
  const whole = now && wholeSection(now, roomOf(now), over.peek());
  if (whole) current.value = fittedLast = whole;
}

/// Moves the view by pixels.
export function moveBy(dx: number, dy: number) {
  if (current.value) current.value = moved(current.value, dx, dy);
}

/// Enlarges the view around a place of the picture; without one, around its centre.
export function zoomBy(factor: number, at?: { x: number; y: number }) {
  const now = current.value;
  if (now) current.value = zoomed(now, factor, at?.x ?? now.width / 2, at?.y ?? now.height / 2);
}

/// The current view in a picture of another size.
export function framedIn(size: { width: number; height: number }): Frame | null {
  const now = frame.peek();
  if (!now) return null;
  if (now === fittedLast) return wholeSection(size, roomOf(size), []);
  const factor = Math.min(size.width / now.width, size.height / now.height);
  return { ...now, ...size, along: now.along * factor, up: now.up * factor };
}

/// The frame of an address, as much of it as the picture can show; null if it is not one of a section.
function frameOf(text: string, { width, height }: Frame): Frame | null {
  const [x, z, across, high] = cameraNumbers(text, 4) ?? [];
  if (x === undefined || z === undefined || !(across! > 0) || !(high! > 0)) return null;
  const [along, up] = [width / across!, height / high!];
  const both = Math.min(along, up);
  return { width, height, x, z, along: equalAxes.peek() ? both : along, up: equalAxes.peek() ? both : up };
}

/// Follows the picture's size and, unless the user moved it, keeps the whole section visible. Returns a function that
/// ends this.
export function keepFramed(host: HTMLElement): () => void {
  const watch = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = host;
    const now = frame.peek();
    if (width === 0 || height === 0 || (now?.width === width && now.height === height)) return;
    const next = now ? { ...now, width, height } : emptyFrame({ width, height });
    if (!now || now === fittedLast) fittedLast = next;
    current.value = next;
  });
  watch.observe(host);
  const endWatching = watchOver(host, (boxes) => (over.value = boxes));
  const take = (wanted: string) => {
    wantCamera(null);
    const now = frame.peek();
    current.value = (now && frameOf(wanted, now)) ?? now;
  };
  let [shown, sizeThen]: [string, string | null] = ['', null];
  // A new slope or new axes are shown whole; otherwise the user's view stays.
  const endFitting = effect(() => {
    const [now, all, boxes] = [frame.value, bounds.value, over.value];
    const state = `${model.value?.project.name ?? ''} ${all?.x} ${all?.z} ${equalAxes.value}`;
    const isNew = state !== shown;
    const size = now && `${now.width} ${now.height} ${JSON.stringify(boxes)}`;
    if (!now || !all || (!isNew && (now !== fittedLast || size === sizeThen || tool.peek() !== null))) return;
    [shown, sizeThen] = [state, size];
    fit();
    const wanted = untracked(() => wantedCamera.value);
    if (wanted !== null) untracked(() => take(wanted));
  });
  const endTaking = effect(() => {
    const wanted = wantedCamera.value;
    if (wanted !== null && shown !== '') untracked(() => take(wanted));
  });
  const endTelling = effect(() => {
    const now = frame.value;
    const isMoved = now !== null && now !== fittedLast && shown !== '';
    tellCamera(isMoved ? cameraText([now.x, now.z, now.width / now.along, now.height / now.up]) : null);
  });
  return () => {
    watch.disconnect();
    endWatching();
    endFitting();
    endTaking();
    endTelling();
    current.value = fittedLast = null;
    over.value = [];
  };
}
