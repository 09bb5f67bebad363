// The display settings of the views. All but the playback speed belong to the project.

import { kept } from '../state/kept';
import { keptOfProject } from '../project/ofProject';

export type Shading = 'elevation' | 'slope' | 'material' | 'hillshade';
export const shading = keptOfProject<Shading>('shading', 'elevation');
export const contours = keptOfProject<boolean>('contours', true);
export const exaggeration = keptOfProject<number>('exaggeration', 1);

export type PathColour = 'speed' | 'energy' | 'height' | 'source' | 'seeder' | 'reason';
export const pathColour = keptOfProject<PathColour>('path colour', 'speed');
/// Simulated seconds per second of playback.
export const playbackSpeed = kept('view playback speed', 1);

export const layers = {
  terrain: keptOfProject<boolean>('terrain', true),
  seeders: keptOfProject<boolean>('seeders', true),
  barriers: keptOfProject<boolean>('barriers', true),
  paths: keptOfProject<boolean>('paths', true),
  ends: keptOfProject<boolean>('ends', true),
  observed: keptOfProject<boolean>('observed', true),
};
export const layerNames = { terrain: 'Terrain', seeders: 'Seeders', barriers: 'Barriers', paths: 'Trajectories', ends: 'End points', observed: 'Observed rocks' } as const;

/// In the section view and in ground sections: the same scale on both axes.
export const equalAxes = keptOfProject<boolean>('equal axes', true);
/// Trajectories at most this far from the line of a ground section are drawn in it [m].
export const corridorWidth = keptOfProject<number>('section corridor', 10);
/// The envelope over the ground section; empty: none.
export const sectionEnvelope = keptOfProject<'' | 'height_m' | 'ke_total_J' | 'velocity_m_s'>('section envelope', 'height_m');
