// Whether inputs and rock models are varied by themselves after each run, remembered by the browser.

import { kept } from './kept';
import { owned } from './owned';

export const [varies, setVaries] = owned(kept('vary inputs after runs', true));
