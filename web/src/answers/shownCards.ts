// Whether the answers are unfolded, remembered by the browser.

import { kept } from '../state/kept';
import { owned } from '../state/owned';

export const [areOpen, openCards] = owned(kept('answers open', true));
