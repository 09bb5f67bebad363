// What the views show and how, as the user left it. All but how fast rocks are played belongs to the project.

import { kept } from '../state/kept';
import { keptOfProject } from '../state/ofProject';

export type Shading = 'elevation' | 'slope' | 'material' | 'hillshade';
export const shading = keptOfProject<Shading>('shading', 'elevation');
export const contours = keptOfProject<boolean>('contours', true);
export const exaggeration = keptOfProject<number>('exaggeration', 1);

export type PathColour = 'speed' | 'energy' | 'height' | 'source' | 'seeder' | 'reason';
export const pathColour = keptOfProject<PathColour>('path colour', 'speed');
/// Seconds of the rocks in a second of the viewer.
export const playbackSpeed = kept('view playback speed', 1);

export const layers = {
  terrain: keptOfProject<boolean>('terrain', true),
  seeders: keptOfProject<boolean>('seeders', true),
  barriers: keptOfProject<boolean>('barriers', true),
  paths: keptOfProject<boolean>('paths', true),
  ends: keptOfProject<boolean>('ends', true),
};
export const layerNames = { terrain: 'Terrain', seeders: 'Seeders', barriers: 'Barriers', paths: 'Paths', ends: 'End points' } as const;

/// In the section view and in sections: one metre up is as long as one metre along.
export const equalAxes = keptOfProject<boolean>('equal axes', true);
