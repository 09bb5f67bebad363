// What the colours of paths mean.

import { arePathsShown } from '../maps/over';
import { isOutdated } from '../runs/outdated';
import { compared, shown } from '../state/runs';
import { cssGradient } from '../view/colours';
import { KindsLegend, ScaleLegend } from '../view/Legend';
import { runColour } from '../view/theme';
import { counted } from '../ui/format';
import { colouring } from './colouring';
import { leftByFilter } from './shownPassing';

/// How many of the paths that are drawn the filter leaves.
function FilterCount() {
  const count = leftByFilter.value;
  if (!count) return null;
  return (
    <p class="legend filtered" role="status">
      {count.left.toLocaleString('en')} of {counted(count.of, 'path')}
    </p>
  );
}

export function PathLegend() {
  const how = colouring.value;
  if (!how || !arePathsShown.value) return null;
  return (
    <>
      {how.kind === 'run' ? (
        <KindsLegend
          title="Paths of two runs"
          kinds={[
            { name: shown.value?.name ?? '', colour: how.colour },
            { name: compared.value?.name ?? '', colour: runColour('compared') },
          ]}
        />
      ) : how.kind === 'scale' ? (
        <ScaleLegend title={how.title} gradient={cssGradient(how.ramp)} low={how.low} high={how.high} isClipped={how.isClipped} />
      ) : (
        <KindsLegend
          title={how.title}
          kinds={how.names.map((name, k) => ({ name, colour: how.colours[k]! })).filter((_, k) => how.isThere[k])}
        />
      )}
      <FilterCount />
      {isOutdated.value && <p class="legend outdated-paths">Paths of an earlier text of the project</p>}
    </>
  );
}
