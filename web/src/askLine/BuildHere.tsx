// Puts a barrier or a collector at the asked line into the project.

import type { LineAnswer } from '../api/line';
import { add } from '../project/things';
import { dimension } from '../project/place';
import { showPanel } from '../state/panels';
import { asked, kitEnergy, kitHeight } from './asked';
import { pointsOf } from './askTools';
import { nearestIndex } from './kit';

export function BuildHere({ of: { kits } }: { of: LineAnswer }) {
  const now = asked.value;
  if (now?.kind !== 'line') return null;
  const height_m = kits.heights_m[nearestIndex(kits.heights_m, kitHeight.value)] ?? kitHeight.value;
  const capacity_kJ = kits.energies_kJ[nearestIndex(kits.energies_kJ, kitEnergy.value)] ?? kitEnergy.value;
  const line = dimension.value === 2 ? pointsOf(now)[0]![0] : pointsOf(now);
  const put = (kind: 'barrier' | 'collector') => {
    add(kind, kind === 'barrier' ? { line, height_m, capacity_kJ } : { line, height_m }, `put a ${kind} at the asked line`);
    showPanel('model');
  };
  return (
    <div class="asked-build">
      <button class="button" onClick={() => put('barrier')}>
        Put a barrier here
      </button>
      <button class="button" onClick={() => put('collector')}>
        Put a collector here
      </button>
    </div>
  );
}
