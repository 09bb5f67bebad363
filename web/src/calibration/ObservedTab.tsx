// Observed stops beside the simulated end points of a run, with the figures of the report.

import { useCallback } from 'preact/hooks';
import { observing } from '../api/calibration';
import { quantityTitle, type ObservedComparison, type ObservedQuantity } from '../archive/observed';
import type { Run } from '../api/types';
import { cumulative, cumulativeRows, type Steps } from '../figures/cumulative';
import type { Room } from '../figures/plot';
import { Chart } from '../charts/Chart';
import { DataTable } from '../charts/DataTable';
import { shownColour } from '../charts/colours';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { Waiting } from '../ui/Waiting';
import { counted } from '../units/numbers';
import { inFolder } from '../project/files';
import { observedStops } from './observations';
import './calibration.css';

function Curves({ run, of, quantity }: { run: Run; of: ObservedComparison; quantity: ObservedQuantity }) {
  const title = quantityTitle(quantity, of);
  const steps: Steps[] = [
    { name: 'simulated', colour: shownColour, points: quantity.simulated!.cumulative },
    { name: 'observed', colour: 'var(--observed)', points: quantity.observed!.cumulative },
  ];
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      cumulative(element, room, { title, unit: 'm', per: 1, thing: 'rock', of: steps }),
    [quantity, title],
  );
  return (
    <Chart
      title={title}
      description={`${title}: cumulative distribution of observed and simulated rocks. The CSV button saves its numbers.`}
      file={fileName(run.name, 'observed', quantity.key)}
      draw={draw}
      rows={() => cumulativeRows(steps, `${quantity.key}_m`)}
    />
  );
}

const text = (value: number) => String(value);

function Comparison({ run, name }: { run: Run; name: string }) {
  const answer = useRemote(`${run.id} ${name}`, `${run.state} ${run.done}`, (signal) =>
    observing.compared(run.id, inFolder(name), signal),
  );
  if (!answer.value) return <Waiting of={answer} />;
  const of = answer.value;
  if (of.rocks === 0) return <div class="empty">The run has no end points in its table.</div>;
  const lines = of.quantities.filter(({ simulated }) => simulated);
  return (
    <section class="observed" aria-label={`Observed stops of ${name}`}>
      {of.problems.map((problem) => (
        <p key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </p>
      ))}
      <div class="figures">
        {lines.map((quantity) => (
          <Curves key={quantity.key} run={run} of={of} quantity={quantity} />
        ))}
        <div>
          <DataTable
            caption={`Energy distance between observed (${name}) and simulated`}
            file={fileName(run.name, 'observed', 'distance')}
            hasHeads
            columns={[
              { key: 'quantity', title: 'Quantity', isText: true },
              { key: 'energy_distance_m', title: 'Distance', unit: 'm' },
              { key: 'by_chance_median_m', title: 'By chance, median', unit: 'm' },
              { key: 'by_chance_95_m', title: 'By chance, 95 %', unit: 'm' },
              { key: 'p_value_percent', title: 'Chance is as far', unit: '%' },
            ]}
            rows={of.quantities.map((quantity) => {
              const { value, median, p95, p_value } = quantity.energy_distance;
              return [quantityTitle(quantity, of), text(value), text(median), text(p95), text(100 * p_value)];
            })}
          />
          <DataTable
            caption="Distributions"
            file={fileName(run.name, 'observed', 'distributions')}
            hasHeads
            columns={[
              { key: 'quantity', title: 'Quantity', isText: true },
              { key: 'of', title: 'Of', isText: true },
              { key: 'mean_m', title: 'Mean', unit: 'm' },
              { key: 'p05_m', title: '5 %', unit: 'm' },
              { key: 'median_m', title: 'Median', unit: 'm' },
              { key: 'p95_m', title: '95 %', unit: 'm' },
            ]}
            rows={lines.flatMap((quantity) =>
              (['observed', 'simulated'] as const).map((which) => {
                const { mean, p05, median, p95 } = quantity[which]!;
                return [quantityTitle(quantity, of), which, ...[mean, p05, median, p95].map(text)];
              }),
            )}
          />
          <p class="faint">
            By chance: as many rocks drawn {of.draws} times from the {counted(of.rocks, 'simulated rock')}. A distance
            beyond the 95 % is hardly due to chance alone. One within it does not prove the model.
          </p>
        </div>
      </div>
    </section>
  );
}

export function ObservedTab({ run }: { run: Run }) {
  return (
    <div class="tab-block">
      {observedStops.value.map(({ file }) => (
        <Comparison key={file} run={run} name={file} />
      ))}
    </div>
  );
}
