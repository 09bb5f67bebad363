// Whether the start page shows the verification cases.

import { signal } from '@preact/signals';
import { owned } from '../state/owned';

export const [verifying, showVerification] = owned(signal(false));
