// Design percentiles along a line with their confidence intervals, and the requirements of the standard.

import type { DesignLine } from '../api/results';
import type { Run } from '../api/types';
import { DataTable } from '../charts/DataTable';
import { titleOf, unitOf } from '../charts/columns';
import { fileName } from '../charts/save';

/// The population of the percentiles: not only rocks that hit the barrier.
const populationOf = ({ rocks }: DesignLine) =>
  rocks === '1'
    ? 'the one rock that crossed its line, at the barrier or above'
    : `all ${Number(rocks).toLocaleString('en')} rocks that crossed its line, at the barrier or above, each at its first crossing`;

export function DesignTable({ run, name, design }: { run: Run; name: string; design: DesignLine }) {
  const quantities = Object.entries(design.percentiles);
  const percents = [...new Set(quantities.flatMap(([, of]) => Object.keys(of)))];
  const rows = quantities.flatMap(([quantity, of]) =>
    percents.map((percent) => {
      const interval = of[percent];
      return [titleOf(quantity), unitOf(quantity), percent, ...[0, 1, 2].map((k) => interval?.[k] ?? '')];
    }),
  );
  const { needs } = design;
  return (
    <div class="design">
      <DataTable
        caption={`Design percentiles of ${populationOf(design)}`}
        file={fileName(run.name, name, 'design')}
        hasHeads
        columns={[
          { key: 'quantity', title: 'Quantity', isText: true },
          { key: 'unit', title: 'Unit', isText: true, isUnit: true },
          { key: 'percentile', title: 'Percentile', unit: '%' },
          { key: 'value', title: 'Value' },
          { key: 'low', title: 'Confidence interval, from' },
          { key: 'high', title: 'to' },
        ]}
        unitAt={(row, c) => (c >= 3 ? rows[row]![1] : undefined)}
        rows={rows}
      />
      {needs ? (
        <DataTable
          caption="Requirements of the standard"
          file={fileName(run.name, name, 'needs')}
          hasHeads
          columns={[
            { key: 'energy_J', title: 'Energy of the kit (MEL)', unit: 'J' },
            { key: 'class', title: 'EAD class' },
            { key: 'height_m', title: 'Height', unit: 'm' },
            { key: 'clearance_m', title: 'Distance to what is protected', unit: 'm' },
            { key: 'most_elongation_m', title: 'Elongation at most', unit: 'm' },
          ]}
          rows={[[needs.energy_J, needs.class ?? '', needs.height_m, design.clearance_m ?? '', design.most_elongation_m ?? '']]}
        />
      ) : (
        <p class="faint">Too few rocks for the check of the standard.</p>
      )}
    </div>
  );
}
