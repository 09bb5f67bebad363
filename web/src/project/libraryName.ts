// The name of a material that takes its values from the library.

import type { LibraryMaterial } from '../api/types';
import { isNameOf } from './likeness';

/// Whether the program gave the name, not the user: "Material 2", or that of a library material, perhaps numbered.
export const isGivenName = (name: unknown, word: string, list: readonly LibraryMaterial[]): boolean =>
  name === undefined || name === '' || isNameOf(name, word) || list.some((material) => isNameOf(name, material.name));
