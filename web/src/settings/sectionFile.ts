// The edits that make a file the section.

import type { Edit, Row } from './names';
import { changeTo, terrainKinds } from './terrainKinds';

/// What belongs to the former section alone: its file's layer, its vertices' deviations, its width in 3D.
const ofSection = ['section_layer', 'section_tolerance_m', 'section_std_dev_m', 'width_m'] as const;

/// The edits that make a file the terrain's section, in 2D.
export function sectionEdits(name: string, terrain: Row<'terrain'>): Edit[] {
  const kind = terrainKinds.find((one) => one.name === 'section')!;
  const stale = ofSection.filter((key) => terrain[key] !== undefined);
  const others = Object.entries(terrain).filter(([key]) => key !== 'section' && !stale.some((own) => own === key));
  return [...stale.map((key) => ({ remove: ['terrain', key] as const })), ...changeTo(kind, Object.fromEntries(others), name)];
}
