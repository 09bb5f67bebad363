// Whether tables show all digits of the files.

import { kept } from '../state/kept';
import { owned } from '../state/owned';

export const [allDigits, showAllDigits] = owned(kept('all digits', false));
