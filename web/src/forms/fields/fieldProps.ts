// Common properties of fields and their controls.

import type { Path } from '../../settings/names';
import { problemsOf } from '../../project/awaited';
import type { Field as Setting } from '../../settings/schema';

export interface FieldProps {
  field: Setting;
  path: Path;
}

/// Further properties of a control with one value.
export interface Common {
  id: string;
  invalid: boolean;
  describedBy?: string;
}

export const idOf = (path: Path) => `field-${path.join('-')}`;
/// The id of the element with the problems of a setting, for aria-describedby.
export const problemsId = (path: Path) => (problemsOf(path).length > 0 ? `${idOf(path)}-problems` : undefined);
