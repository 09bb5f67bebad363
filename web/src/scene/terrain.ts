// The interface of terrains in the scene.

import type { Camera, Object3D, Ray, Vector3 } from 'three';

export interface Hit {
  /// In the scene's coordinates, without vertical exaggeration.
  point: Vector3;
  distance: number;
  /// The triangle of a mesh.
  facet?: number;
  /// The terrain is drawn at lower resolution here.
  isCoarse?: boolean;
}

export interface Terrain {
  object: Object3D;
  /// Selects the parts and resolution to draw; `pixels` is the height of the picture.
  select(camera: Camera & { fov: number }, pixels: number, exaggeration: number): void;
  /// The number of selected parts that are not loaded yet.
  readonly missing?: number;
  /// The first intersection with a ray, in the scene's coordinates without exaggeration.
  pick(ray: Ray): Hit | null;
  /// Some hundreds of points spread over the terrain.
  samplePoints(): Vector3[];
  /// Loads further parts from this model, which has the same terrain.
  useModel?(model: string): void;
  dispose(): void;
}
