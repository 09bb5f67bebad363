// Conversion between metres of the section and pixels of its picture.

import { heightOf, widthOf, type Box } from '../geometry/framing';

export interface Frame {
  width: number;
  height: number;
  /// The point of the section at the centre of the picture [m].
  x: number;
  z: number;
  /// Pixels per metre, horizontally and vertically.
  along: number;
  up: number;
}

export interface Bounds {
  x: [number, number];
  z: [number, number];
}

export const pixelOf = (frame: Frame, x: number, z: number): [number, number] => [
  frame.width / 2 + (x - frame.x) * frame.along,
  frame.height / 2 - (z - frame.z) * frame.up,
];

export const placeOf = (frame: Frame, left: number, top: number): [number, number] => [
  frame.x + (left - frame.width / 2) / frame.along,
  frame.z - (top - frame.height / 2) / frame.up,
];

/// The frame that fits the bounds into a box of the picture, centred.
export function fitted(bounds: Bounds, { width, height }: { width: number; height: number }, box: Box, equal: boolean): Frame {
  const span = ([low, high]: [number, number]) => Math.max(high - low, 1e-3);
  const along = widthOf(box) / span(bounds.x);
  const up = heightOf(box) / span(bounds.z);
  const both = Math.min(along, up);
  const frame = { width, height, x: 0, z: 0, along: equal ? both : along, up: equal ? both : up };
  frame.x = (bounds.x[0] + bounds.x[1]) / 2 - ((box.left + box.right) / 2 - width / 2) / frame.along;
  frame.z = (bounds.z[0] + bounds.z[1]) / 2 + ((box.top + box.bottom) / 2 - height / 2) / frame.up;
  return frame;
}

/// Zooms by a factor about a pixel.
export function zoomed(frame: Frame, factor: number, left: number, top: number): Frame {
  const along = frame.along * factor;
  if (along < 1e-4 || along > 1e5) return frame;
  const [x, z] = placeOf(frame, left, top);
  const next = { ...frame, along, up: frame.up * factor };
  const [nowX, nowZ] = placeOf(next, left, top);
  return { ...next, x: frame.x + x - nowX, z: frame.z + z - nowZ };
}

/// Moves the picture by an offset in pixels.
export const moved = (frame: Frame, left: number, top: number): Frame => ({
  ...frame,
  x: frame.x - left / frame.along,
  z: frame.z + top / frame.up,
});
