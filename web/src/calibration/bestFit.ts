// The best fit of a calibration as edits of a project's text.

import { pathOf, type Edit } from '../settings/names';
import { valuesOf } from '../toml/values';

/// The edit of a setting as the engine writes it: "material.0.roughness_deg={ mean = 4, ... }".
export function editOf(setting: string): Edit {
  const at = setting.indexOf('=');
  return { set: pathOf(setting.slice(0, at)), value: valuesOf(`value = ${setting.slice(at + 1)}`).value! };
}
