// Names of the rock models.

import { wordText } from '../settings/words';

const short: Readonly<Record<string, string>> = { rigid_sphere: 'sphere', rigid_body: 'shape' };

/// "lumped mass", "sphere", "shape": as short as a card needs it.
export const modelName = (model: string | undefined): string => short[model ?? ''] ?? wordText(model ?? '');
