// Envelopes of energy, velocity and bounce height along a section.

import { useCallback, useMemo, useState } from 'preact/hooks';
import { results } from '../api/results';
import type { Run } from '../api/types';
import { envelope, envelopeRows, type EnvelopeQuantity } from '../figures/envelope';
import { titleOf, type Room } from '../figures/plot';
import { Chart } from '../charts/Chart';
import { displayOf } from '../state/displayUnits';
import { envelopesOf, quantitiesOf } from './envelopes';
import { shownColour } from '../charts/colours';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { Waiting } from '../ui/Waiting';

/// The file's numbers are divided by `per` of the quantity for its unit, and further for the unit in which it is shown.
function inDisplayedUnit(quantity: EnvelopeQuantity): EnvelopeQuantity {
  const { unit, per } = displayOf(quantity.unit);
  return { ...quantity, unit, per: quantity.per * per };
}

export function EnvelopesTab({ run }: { run: Run }) {
  const answer = useRemote(run.id, `${run.state} ${run.done}`, (signal) =>
    results.fileText(run.id, 'envelopes.csv', signal),
  );
  const [chosen, choose] = useState('energy_total');
  const cells = useMemo(() => envelopesOf(answer.value ?? '', run.name, shownColour), [answer.value, run.name]);
  const quantities = useMemo(() => quantitiesOf(cells), [cells]);
  const quantity = quantities.find(({ key }) => key === chosen) ?? quantities[0];
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      quantity && envelope(element, room, { ...inDisplayedUnit(quantity), of: [cells], walls: [] }),
    [cells, quantity],
  );
  if (answer.value === null) return <Waiting of={answer} />;
  if (!quantity || cells.x.length === 0) return <div class="empty">No rock moved.</div>;
  return (
    <div class="tab-block">
      <Chart
        title="Along the section"
        description={`${titleOf(inDisplayedUnit(quantity))} in cells along the section. The CSV button saves the numbers.`}
        file={fileName(run.name, `envelope ${quantity.key}`)}
        draw={draw}
        rows={() => envelopeRows([cells], quantity.key)}
        tools={
          <select
            aria-label="Quantity along the section"
            value={quantity.key}
            onChange={(event) => choose(event.currentTarget.value)}
          >
            {quantities.map((each) => (
              <option key={each.key} value={each.key}>
                {titleOf(inDisplayedUnit(each))}
              </option>
            ))}
          </select>
        }
      />
    </div>
  );
}
