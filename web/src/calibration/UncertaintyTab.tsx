// The figures of a run whose rocks draw their parameters from a posterior, with the parts of their uncertainty.

import { useCallback } from 'preact/hooks';
import { observing } from '../api/calibration';
import { figureTitle, type FigureUncertainty, type RangeOf } from '../archive/uncertainty';
import type { Run } from '../api/types';
import type { Room } from '../figures/plot';
import { tornado } from '../figures/tornado';
import { Chart } from '../charts/Chart';
import { DataTable } from '../charts/DataTable';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { Waiting } from '../ui/Waiting';
import './calibration.css';

/// Shares have no unit in the files and are shown in percent.
const scaled = ({ unit }: FigureUncertainty, value: number) => String(unit === '' ? 100 * value : value);
const ends = (figure: FigureUncertainty, [, low, high]: RangeOf) => [scaled(figure, low), scaled(figure, high)];

function Parts({ run, figures }: { run: Run; figures: readonly FigureUncertainty[] }) {
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      tornado(element, room, {
        title: 'Part of the parameters in the variance between ensembles',
        unit: '%',
        per: 1,
        bars: figures.map((each) => ({ name: figureTitle(each), value: 100 * each.parameter_share, low: null, high: null })),
      }),
    [figures],
  );
  return (
    <div class="uncertainty-parts">
      <Chart
        title="Part of the parameters"
        description="Part of the parameters in the variance of each figure between ensembles; the rest is that of the rocks. The table has the numbers."
        file={fileName(run.name, 'uncertainty', 'parts')}
        draw={draw}
        rows={() => [['figure', 'parameters', 'rocks'], ...figures.map((each) => [figureTitle(each), each.parameter_share, 1 - each.parameter_share])]}
      />
    </div>
  );
}

export function UncertaintyTab({ run }: { run: Run }) {
  const answer = useRemote(run.id, `${run.state} ${run.done}`, (signal) => observing.uncertainty(run.id, signal));
  if (!answer.value) return <Waiting of={answer} />;
  const { ensembles, confidence, figures } = answer.value;
  if (ensembles === 0) return <div class="empty">The rocks of this run have no ensembles of parameters.</div>;
  if (figures.length === 0) return <div class="empty">The run has too few rocks for ranges between its ensembles.</div>;
  const percent = Math.round(100 * confidence);
  return (
    <div class="tab-block">
      <p class="faint">
        Each of {ensembles} ensembles has parameters of its own. The range between ensembles contains both parts: that of
        the parameters, which more knowledge of the site would lessen, and that of the rocks, the chance in an ensemble of
        so many rocks. Variances add up; ranges do not.
      </p>
      <DataTable
        caption={`Figures with their ${percent} % ranges over ${ensembles} ensembles`}
        file={fileName(run.name, 'uncertainty')}
        hasHeads
        columns={[
          { key: 'figure', title: 'Figure', isText: true },
          { key: 'unit', title: 'Unit', isText: true, isUnit: true },
          { key: 'value', title: 'All rocks' },
          { key: 'low', title: 'Ensembles, from' },
          { key: 'high', title: 'to' },
          { key: 'parameters_low', title: 'Parameters, from' },
          { key: 'parameters_high', title: 'to' },
          { key: 'rocks_low', title: 'Rocks, from' },
          { key: 'rocks_high', title: 'to' },
          { key: 'parameter_share', title: 'Parameters’ part', unit: '%' },
        ]}
        unitAt={(row, column) => (column >= 2 && column <= 8 ? figures[row]!.unit || '%' : undefined)}
        rows={figures.map((each) => [
          figureTitle(each),
          each.unit || '%',
          scaled(each, each.total[0]),
          ...ends(each, each.total),
          ...ends(each, each.parameters),
          ...ends(each, each.rocks),
          String(100 * each.parameter_share),
        ])}
      />
      <Parts run={run} figures={figures} />
    </div>
  );
}
