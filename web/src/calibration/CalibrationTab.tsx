// The results of a calibration: what is known of each parameter, and how well it predicts the observations.

import { useCallback, useMemo, useState } from 'preact/hooks';
import type { CalibratedGroup, CalibrationSummary } from '../archive/calibration';
import { observing } from '../api/calibration';
import { fileAddress, results } from '../api/results';
import type { Run } from '../api/types';
import { parameterPairs, parameterShareRows, parameterShares, predictedShareRows, predictedShares } from '../figures/bands';
import { zoneShareRows, zoneShares } from '../figures/zoneShares';
import { titled } from '../settings/titles';
import { numberText, counted } from '../units/numbers';
import { titleOf, type Room } from '../figures/plot';
import { Chart } from '../charts/Chart';
import { DataTable } from '../charts/DataTable';
import { useRemote } from '../ui/remote';
import { fileName } from '../charts/save';
import { Waiting } from '../ui/Waiting';
import { stateText } from '../runList/RunStateText';
import { reportFailure } from '../state/messages';
import { shownCalibration } from '../runs/runs';
import { ensembles, openBestFit, predictWithPosterior } from './predictions';
import './calibration.css';

type Parameter = CalibrationSummary['parameters'][number];
type Feature = CalibrationSummary['observations'][number]['features'][number];

const text = (value: number | null | undefined) => (value === null || value === undefined ? '' : String(value));

function ParameterChart({ run, parameter, best }: { run: Run; parameter: Parameter; best: number }) {
  const { title, unit, histogram, posterior } = titled(parameter);
  const shown = useMemo(
    () => ({
      title,
      unit,
      best,
      ...histogram!,
      quantiles: [posterior!.p05, posterior!.p50, posterior!.p95] as const,
    }),
    [parameter, best],
  );
  const draw = useCallback((element: SVGSVGElement, room: Room) => parameterShares(element, room, shown), [shown]);
  const { p05, p50, p95 } = posterior!;
  return (
    <Chart
      title={title}
      description={`Prior and posterior of ${title}. Posterior: 5 % ${numberText(p05, 4)}, median ${numberText(p50, 4)}, 95 % ${numberText(p95, 4)} ${unit}. The CSV button saves the shares.`}
      file={fileName(run.name, title)}
      draw={draw}
      rows={() => parameterShareRows(shown)}
    />
  );
}

/// The rows of posterior.csv as numbers by column. A quoted name has its quotes doubled inside.
function posteriorRows(csv: string): Record<string, number>[] {
  const [head = '', ...lines] = csv.trim().split('\n');
  const names = [...head.matchAll(/"((?:[^"]|"")*)"|([^,]+)/g)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain!);
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, k) => [names[k] ?? '', Number(value)])));
}

function Pairs({ run, summary }: { run: Run; summary: CalibrationSummary }) {
  const answer = useRemote(run.id, run.state, (signal) => results.fileText(run.id, 'posterior.csv', signal));
  const { parameters, correlations } = summary;
  const pairs = parameters.flatMap((_, a) => parameters.slice(0, a).map((_one, b) => [b, a] as const));
  const [chosen, choose] = useState(0);
  const [first, second] = pairs[chosen] ?? pairs[0]!;
  const [x, y] = [titled(parameters[first]!), titled(parameters[second]!)];
  const rows = useMemo(() => posteriorRows(answer.value ?? ''), [answer.value]);
  const draw = useCallback(
    (element: SVGSVGElement, room: Room) =>
      parameterPairs(element, room, {
        x,
        y,
        sets: rows.map((row) => ({ x: row[x.name]!, y: row[y.name]!, weight: row.weight! })),
      }),
    [rows, x, y],
  );
  if (answer.value === null) return <Waiting of={answer} />;
  const correlation = correlations?.[second]?.[first];
  return (
    <Chart
      title="Pairs"
      description={`Sets of the posterior by ${x.name} and ${y.name}; the area of a dot is the weight of its set. Correlation ${text(correlation)}.`}
      file={fileName(run.name, 'pairs')}
      draw={draw}
      rows={() => [[x.name, y.name, 'weight'], ...rows.map((row) => [row[x.name]!, row[y.name]!, row.weight!])]}
      tools={
        <>
          <select aria-label="Pair of parameters" value={chosen} onChange={(event) => choose(Number(event.currentTarget.value))}>
            {pairs.map(([a, b], k) => (
              <option key={k} value={k}>
                {titled(parameters[a]!).title} – {titled(parameters[b]!).title}
              </option>
            ))}
          </select>
          {correlation !== undefined && <span class="faint correlation">correlation {correlation.toFixed(2)}</span>}
        </>
      }
    />
  );
}

function PredictionChart({ run, name, feature }: { run: Run; name: string; feature: Feature }) {
  const title = `${feature.name}, ${name}`;
  const shown = useMemo(() => ({ title: feature.name, unit: feature.unit, ...feature.distribution! }), [feature]);
  const draw = useCallback((element: SVGSVGElement, room: Room) => predictedShares(element, room, shown), [shown]);
  return (
    <Chart
      title={`Observed and predicted: ${title}`}
      description={`Cumulative distribution of ${title}: observed, and the bands within which 90 % of as many rocks lie by the posterior and by the prior.`}
      file={fileName(run.name, feature.name, name)}
      draw={draw}
      rows={() => predictedShareRows(shown)}
    />
  );
}

function ZoneChart({ run, group }: { run: Run; group: CalibratedGroup }) {
  const draw = useCallback((element: SVGSVGElement, room: Room) => zoneShares(element, room, group.zones ?? []), [group]);
  return (
    <Chart
      title={`Deposits by zone: ${group.name}`}
      description={`Shares of the deposits of ${group.name} by zone: observed, and the range within which 90 % of as many rocks lie by the posterior.`}
      file={fileName(run.name, 'zones', group.name)}
      draw={draw}
      rows={() => zoneShareRows(group.zones ?? [])}
    />
  );
}

function Tables({ run, summary }: { run: Run; summary: CalibrationSummary }) {
  const { parameters, observations, held_out: heldOut, held_out_coverage: coverage = [], best } = summary;
  return (
    <div class="calibration-tables">
      <DataTable
        caption="What is known of each parameter"
        file={fileName(run.name, 'parameters')}
        hasHeads
        columns={[
          { key: 'parameter', title: 'Parameter', isText: true },
          { key: 'prior_05', title: 'Prior, 5 %' },
          { key: 'prior_95', title: '95 %' },
          { key: 'posterior_05', title: 'Posterior, 5 %' },
          { key: 'posterior_50', title: '50 %' },
          { key: 'posterior_95', title: '95 %' },
          { key: 'best', title: 'Best set' },
          { key: 'width', title: 'Width, posterior over prior' },
        ]}
        rows={parameters.map(titled).map(({ name, title, unit, prior, posterior, width_of_prior }) => [
          titleOf({ title, unit }),
          ...[prior.p05, prior.p95, posterior?.p05, posterior?.p50, posterior?.p95, best.values[name], width_of_prior].map(text),
        ])}
      />
      <DataTable
        caption="How well the observations are met: distance over the observed spread"
        file={fileName(run.name, 'fit')}
        hasHeads
        columns={[
          { key: 'observations', title: 'Observations', isText: true },
          { key: 'count', title: 'Number' },
          { key: 'best_distance', title: 'Best set' },
          { key: 'threshold', title: 'By chance alone, 95 %' },
        ]}
        rows={observations.map(({ name, count, best_distance, threshold }) => [name, text(count), text(best_distance), text(threshold)])}
      />
      <DataTable
        caption="Observed and predicted"
        file={fileName(run.name, 'predicted')}
        hasHeads
        columns={[
          { key: 'feature', title: 'Quantity', isText: true },
          { key: 'observed_mean', title: 'Observed, mean' },
          { key: 'observed_std_dev', title: 'standard deviation' },
          { key: 'predicted_mean', title: 'Predicted, mean' },
          { key: 'predicted_std_dev', title: 'standard deviation' },
        ]}
        rows={observations.flatMap(({ name, features }) =>
          features.map((each) => [
            `${each.name}, ${name}${each.unit ? ` [${each.unit}]` : ''}`,
            ...[each.observed_mean, each.observed_std_dev, each.predicted_mean, each.predicted_std_dev].map(text),
          ]),
        )}
      />
      {observations.some(({ zones }) => zones) && (
        <DataTable
          caption="Shares of deposits by zone"
          file={fileName(run.name, 'zones')}
          hasHeads
          columns={[
            { key: 'zone', title: 'Zone', isText: true },
            { key: 'observed_share', title: 'Observed' },
            { key: 'predicted_05', title: 'Predicted, 5 %' },
            { key: 'predicted_50', title: '50 %' },
            { key: 'predicted_95', title: '95 %' },
          ]}
          rows={observations.flatMap(({ zones = [] }) =>
            zones.map(({ name, observed_share, predicted_share: { p05, p50, p95 } }) => [
              name,
              ...[observed_share, p05, p50, p95].map(text),
            ]),
          )}
        />
      )}
      {heldOut.length > 0 && (
        <DataTable
          caption="Predictions of observations that were held out: scores over the observed spread; lower is better"
          file={fileName(run.name, 'held out')}
          hasHeads
          columns={[
            { key: 'held_out', title: 'Held out', isText: true },
            { key: 'observations', title: 'Observations' },
            { key: 'posterior', title: 'Posterior' },
            { key: 'prior', title: 'Prior' },
            { key: 'constant', title: 'The other observations' },
          ]}
          rows={heldOut.map((each) => [each.name, ...[each.observations, each.posterior, each.prior, each.constant].map(text)])}
        />
      )}
      {coverage.length > 0 && (
        <DataTable
          caption="Held-out observations within the central 90 % of their prediction, and the number expected in 95 % of cases if predictions hold what they claim"
          file={fileName(run.name, 'held-out coverage')}
          hasHeads
          columns={[
            { key: 'observations', title: 'Held out', isText: true },
            { key: 'name', title: 'Quantity', isText: true },
            { key: 'count', title: 'Observations' },
            { key: 'within_90', title: 'Within 90 %' },
            { key: 'least_expected', title: 'Least expected' },
            { key: 'most_expected', title: 'Most expected' },
          ]}
          rows={coverage.map((each) => [each.observations, each.name, ...[each.count, each.within_90, ...each.expected].map(text)])}
        />
      )}
    </div>
  );
}

function Results({ run }: { run: Run }) {
  const answer = useRemote(run.id, run.state, (signal) => observing.calibration(run.id, signal));
  const [isMaking, setMaking] = useState(false);
  if (!answer.value) return <Waiting of={answer} />;
  const summary = answer.value;
  const hasPosterior = summary.effective_sets > 0;
  const make = (task: () => Promise<void>) => {
    setMaking(true);
    void task()
      .catch(reportFailure)
      .finally(() => setMaking(false));
  };
  return (
    <div class="tab-block calibration-results">
      <div class="calibration-head">
        <p>
          {counted(summary.sets, 'set')} of {counted(summary.rocks_per_set, 'rock')};{' '}
          {summary.agreeing_sets.toLocaleString('en')} as near to the observations as chance alone gives. The posterior is
          as accurate as {Math.round(summary.effective_sets).toLocaleString('en')} independent sets.
        </p>
        <div class="row">
          <button
            class="button first"
            disabled={!hasPosterior || isMaking}
            title={`A new project whose rocks belong to ${ensembles} ensembles, each with a set of the posterior`}
            onClick={() => make(() => predictWithPosterior(run))}
          >
            Predict with the posterior
          </button>
          <button
            class="button"
            disabled={isMaking}
            title="A new project with the values of the set of least score"
            onClick={() => make(() => openBestFit(run, summary))}
          >
            Open the best fit
          </button>
          <a class="button" href={fileAddress(run.id, 'report.html')} download>
            Report
          </a>
        </div>
        {summary.best.note && <p>{summary.best.note}.</p>}
        {run.problems.map(({ text: warning, severity }) => (
          <p key={warning} class={`problem ${severity}`}>
            {warning}
          </p>
        ))}
      </div>
      <div class="figures">
        {hasPosterior &&
          summary.parameters.map((parameter) => (
            <ParameterChart key={parameter.name} run={run} parameter={parameter} best={summary.best.values[parameter.name]!} />
          ))}
        {hasPosterior &&
          summary.observations.flatMap(({ name, features }) =>
            features.map((feature) =>
              feature.distribution && feature.distribution.at.length > 0 ? (
                <PredictionChart key={`${name} ${feature.name}`} run={run} name={name} feature={feature} />
              ) : null,
            ),
          )}
        {hasPosterior &&
          summary.observations.map((group) => (group.zones && group.zones.length > 0 ? <ZoneChart key={group.name} run={run} group={group} /> : null))}
        {hasPosterior && summary.parameters.length > 1 && <Pairs run={run} summary={summary} />}
      </div>
      <Tables run={run} summary={summary} />
    </div>
  );
}

export function CalibrationTab() {
  const run = shownCalibration.value;
  if (!run) return <div class="empty">No calibration is shown.</div>;
  if (run.has_results) return <Results key={run.id} run={run} />;
  return (
    <div class="empty">
      <p>{stateText(run)}. Results appear when the calibration is done.</p>
      {run.problems.map((problem) => (
        <span key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </span>
      ))}
    </div>
  );
}
