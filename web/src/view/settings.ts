// What the views show and how, as the user left it.

import { signal, effect } from '@preact/signals';

function kept<T>(key: string, first: T) {
  const found = localStorage.getItem(`view ${key}`);
  const value = signal<T>(found === null ? first : (JSON.parse(found) as T));
  effect(() => localStorage.setItem(`view ${key}`, JSON.stringify(value.value)));
  return value;
}

export type Shading = 'elevation' | 'slope' | 'material' | 'hillshade';
export const shading = kept<Shading>('shading', 'elevation');
export const contours = kept('contours', true);
export const exaggeration = kept('exaggeration', 1);

export type PathColour = 'speed' | 'energy' | 'height' | 'source' | 'seeder' | 'reason';
export const pathColour = kept<PathColour>('path colour', 'speed');
/// Seconds of the rocks in a second of the viewer.
export const playbackSpeed = kept('playback speed', 1);

export const layers = {
  terrain: kept('terrain', true),
  seeders: kept('seeders', true),
  barriers: kept('barriers', true),
  paths: kept('paths', true),
  ends: kept('ends', true),
};
export const layerNames = { terrain: 'Terrain', seeders: 'Seeders', barriers: 'Barriers', paths: 'Paths', ends: 'End points' } as const;

/// In the section view and in sections: one metre up is as long as one metre along.
export const equalAxes = kept('equal axes', true);
