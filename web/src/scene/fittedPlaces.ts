// Places that must not be overlooked in a scene: the line, area or barrier that is asked.

import type { Vector3 } from 'three';
import type { Name } from './nameLayer';
import type { Stage } from './stage';

export interface Place {
  name: string;
  colour: string;
  isFitted: boolean;
  /// In the scene's coordinates.
  points: Vector3[];
}

function isSeen(stage: Stage, point: Vector3): boolean {
  const [pixel, { width, height }] = [stage.pixelOf(point), stage.size];
  return pixel !== null && pixel.x >= 0 && pixel.y >= 0 && pixel.x <= width && pixel.y <= height;
}

export const isInView = (stage: Stage, { points }: Place): boolean => points.every((point) => isSeen(stage, point));

/// Its name at an end, or else at another of its points that is in the picture; null: none is.
export function nameOf(stage: Stage, { name, colour, points }: Place): Name | null {
  const [first, last] = [points[0], points.at(-1)];
  const at = [last, first, ...points].find((point) => point !== undefined && isSeen(stage, point));
  return at ? { text: name, at, plate: colour } : null;
}
