// Names of the rock models.

import type { Variation } from '../api/whatIf';
import { wordText } from '../settings/words';

/// "lumped mass", "rigid sphere", "rigid body"
export const modelName = (model: string | undefined): string => wordText(model ?? '');

/// "rigid body (block)": with the shapes that the seeders of a project without shapes were given.
export function modelText({ model, changes }: Pick<Variation, 'model' | 'changes'>): string {
  const shapes = new Set(changes.filter(({ path }) => path[2] === 'shape').map(({ after }) => wordText(String(after))));
  return shapes.size > 0 ? `${modelName(model)} (${[...shapes].join(', ')})` : modelName(model);
}
