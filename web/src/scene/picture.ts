// What is said about the picture beside it.

import { signal } from '@preact/signals';
import type { Place } from './tool';

/// Where the pointer is on the ground.
export const pointer = signal<Place | null>(null);
export const camera = signal({ metresPerPixel: 1, /** Degrees from north, clockwise, toward which one looks. */ heading: 0 });
/// Metres between contour lines; 0: none are drawn.
export const contourInterval = signal(0);
/// The shading's range of values, for the legend.
export const elevations = signal<[number, number]>([0, 1]);
/// Why there is no picture.
export const failure = signal<string | null>(null);
export const isLoading = signal(false);
