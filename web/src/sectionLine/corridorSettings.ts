// What is drawn over a ground section.

import { keptOfProject } from '../project/ofProject';
import { owned } from '../state/owned';

/// Trajectories at most this far from the line are drawn [m].
export const [corridorWidth, setCorridorWidth] = owned(keptOfProject<number>('section corridor', 10));

export type SectionEnvelope = '' | 'height_m' | 'ke_total_J' | 'velocity_m_s';
/// The envelope over the ground; empty: none.
export const [sectionEnvelope, showEnvelope] = owned(keptOfProject<SectionEnvelope>('section envelope', 'height_m'));
