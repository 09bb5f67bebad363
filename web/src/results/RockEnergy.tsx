import { useCallback } from 'preact/hooks';
import type { RockAnswer, Run } from '../api/types';
import { energy } from '../figures/energy';
import { numberText } from '../units/numbers';
import type { Room } from '../figures/plot';
import { Chart } from '../charts/Chart';
import { displayOf } from '../state/displayUnits';
import { asInFiles } from '../charts/columns';
import { fileName } from '../charts/save';

/// The energies of a rock over time.
export function RockEnergy({ run, rock, path }: { run: Run; rock: number; path: RockAnswer }) {
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) => {
      const rows = path.energy.map(([time, translational, rotational, potential]) => ({
        place: time,
        translational,
        rotational,
        potential,
        text: `${numberText(time)} s`,
      }));
      energy(element, room, { xLabel: 'Time [s]', rows, hasDots: false, ...displayOf('J') });
    },
    [path],
  );
  return (
    <Chart
      title="Energy over time"
      description={`Translational and rotational kinetic energy and potential energy of rock ${rock} over time. The CSV button saves their numbers.`}
      file={fileName(run.name, `rock ${rock} energy`)}
      draw={draw}
      saving={asInFiles()}
      rows={() => [['time_s', 'ke_translational_J', 'ke_rotational_J', 'pe_J'], ...path.energy]}
    />
  );
}
