// What a setting's field and the control in it both know.

import type { Path } from '../names';
import { problemsOf } from '../awaited';
import type { Field as Setting } from '../schema';

export interface FieldProps {
  field: Setting;
  path: Path;
}

/// What a control of one value needs besides it.
export interface Common {
  id: string;
  invalid: boolean;
  describedBy?: string;
}

export const idOf = (path: Path) => `field-${path.join('-')}`;
/// Where it stands what is said of a setting, for its controls to point at.
export const sayingsId = (path: Path) => (problemsOf(path).length > 0 ? `${idOf(path)}-problems` : undefined);
