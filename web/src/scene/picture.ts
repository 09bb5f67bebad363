// The state of the scene that controls next to it show.

import { signal } from '@preact/signals';
import type { Place } from '../tools/tool';

/// The point of the ground under the pointer.
export const pointer = signal<Place | null>(null);
/// The contour interval [m]; 0: no contours.
export const contourInterval = signal(0);
/// The range of elevations, for the legend.
export const elevations = signal<[number, number]>([0, 1]);
/// The reason why there is no picture.
export const failure = signal<string | null>(null);
export const isLoading = signal(false);
