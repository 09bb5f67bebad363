// The display settings of the views, which belong to the project.

import type { ReadonlySignal } from '@preact/signals';
import { keptOfProject } from '../project/ofProject';
import { owned } from '../state/owned';

export type Shading = 'elevation' | 'slope' | 'material' | 'hillshade';
export const [shading, setShading] = owned(keptOfProject<Shading>('shading', 'elevation'));
export const [contours, setContours] = owned(keptOfProject<boolean>('contours', true));
export const [exaggeration, setExaggeration] = owned(keptOfProject<number>('exaggeration', 1));

const shown = {
  terrain: keptOfProject<boolean>('terrain', true),
  seeders: keptOfProject<boolean>('seeders', true),
  barriers: keptOfProject<boolean>('barriers', true),
  paths: keptOfProject<boolean>('paths', true),
  ends: keptOfProject<boolean>('ends', true),
  observed: keptOfProject<boolean>('observed', true),
};
export type LayerName = keyof typeof shown;
export const layers: Readonly<Record<LayerName, ReadonlySignal<boolean>>> = shown;
export const showLayer = (name: LayerName, shows: boolean) => void (shown[name].value = shows);
export const layerNames: Readonly<Record<LayerName, string>> = { terrain: 'Terrain', seeders: 'Seeders', barriers: 'Barriers', paths: 'Trajectories', ends: 'End points', observed: 'Observed rocks' };

/// In the section view and in ground sections: the same scale on both axes.
export const [equalAxes, setEqualAxes] = owned(keptOfProject<boolean>('equal axes', true));
