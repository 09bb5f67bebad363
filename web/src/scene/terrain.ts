// The interface of terrains in the scene.

import type { Box3, Camera, Mesh, Object3D, Ray, Vector3 } from 'three';

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
  /// Selects the parts and resolution to draw; `pixels` is the height of the picture. With `cells` above 1, while the view
  /// moves, cells may be larger by about this factor.
  select(camera: Camera & { fov: number }, pixels: number, exaggeration: number, cells: number): void;
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

export interface PickedTile {
  distance: number;
  /// The triangle of a mesh; unknown in a coarse tile.
  facet?: number;
}

/// A part of a terrain at one level of detail.
export interface TerrainTile {
  mesh: Mesh;
  /// In the scene's coordinates, without vertical exaggeration.
  box: Box3;
  /// About how much memory it takes.
  bytes: number;
  /// The turn in which it was last visible.
  used: number;
  pick(ray: Ray): PickedTile | null;
  /// Draws the tile with cells that are larger by about this factor, 1: all; without it, coarser tiles are chosen.
  thin?(cells: number): void;
  /// At most about `most` squared points spread over it.
  samplePoints(most: number): Vector3[];
  dispose(): void;
}
