// Names of the rock models.

import type { Variation } from '../api/whatIf';
import { rockModels } from '../figures/rockModels';
import { wordText } from '../settings/words';

/// "lumped mass", "rigid sphere", "rigid body"
export const modelName = (model: string | undefined): string => rockModels[model ?? ''] ?? '';

/// "rigid body (block)": with the shapes of its blocks.
export function modelText({ model, shapes = [] }: Pick<Variation, 'model' | 'shapes'>): string {
  return shapes.length > 0 ? `${modelName(model)} (${shapes.map(wordText).join(', ')})` : modelName(model);
}
