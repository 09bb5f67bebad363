// The state of the scene that controls next to it show.

import { signal } from '@preact/signals';
import type { Place } from '../tools/tool';
import { owned } from '../state/owned';

/// The point of the ground under the pointer.
export const [pointer, setPointer] = owned(signal<Place | null>(null));
/// The contour interval [m]; 0: no contours.
export const [contourInterval, setContourInterval] = owned(signal(0));
/// The range of elevations, for the legend.
export const [elevations, setElevations] = owned(signal<[number, number]>([0, 1]));
/// The reason why there is no picture.
export const [failure, setFailure] = owned(signal<string | null>(null));
export const [isLoading, setLoading] = owned(signal(false));
