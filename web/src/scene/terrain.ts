// What the scene asks of a terrain, whatever it is made of.

import type { Camera, Object3D, Ray, Vector3 } from 'three';

export interface Hit {
  /// In the scene's coordinates, without vertical exaggeration.
  point: Vector3;
  distance: number;
  /// The triangle of a mesh.
  facet?: number;
  /// The terrain is drawn coarser here than it is.
  isCoarse?: boolean;
}

export interface Terrain {
  object: Object3D;
  /// Chooses what is drawn from here; `pixels` is the height of the picture.
  look(camera: Camera & { fov: number }, pixels: number, exaggeration: number): void;
  /// So many parts that `look` chose are still to be fetched.
  readonly missing?: number;
  /// The first place that a ray meets, in the scene's coordinates without exaggeration.
  pick(ray: Ray): Hit | null;
  /// Some hundreds of places of the ground, spread over all of it.
  places(): Vector3[];
  /// What is fetched from now on is of this model, whose terrain is the same.
  askOf?(model: string): void;
  dispose(): void;
}
