// The ditch card: where rocks of the shown run strike a stretch, how far they get, and the published criteria beside it.

import type { Distances, DitchAnswer } from '../api/ditch';
import { intervalText, percentText } from '../askLine/kit';
import { isOutdated } from '../runs/outdated';
import { hasResults, shown } from '../runs/runs';
import { counted, fixedText, numberText } from '../units/numbers';
import { Compared } from './Compared';
import { NumberInput } from './NumberInput';
import { refused, stays } from './stays';
import { setStretch, stretch } from './state';

const percentiles = ['50', '90', '95', '99'];

function DistanceCell({ of, percentile, width }: { of: Distances; percentile: string; width: number }) {
  const found = of.percentiles[percentile];
  if (!found) return <td>–</td>;
  const [value, low, high] = found.map((each) => (each === null ? null : fixedText(each, 2)));
  const isCut = of.known_to_m !== null && found[0] >= of.known_to_m;
  return (
    <td class={found[0] > width ? 'beyond' : undefined}>
      <strong>
        {isCut && '≥ '}
        {value}
      </strong>
      <span class="interval">{isCut ? 'cut by the barrier' : `${low ?? '?'} to ${high ?? '?'}`}</span>
    </td>
  );
}

function DistanceTable({ of }: { of: DitchAnswer }) {
  return (
    <table class="slope-distances">
      <thead>
        <tr>
          <th>of rocks</th>
          <th>First impact within, m</th>
          <th>Roll-out within, m</th>
        </tr>
      </thead>
      <tbody>
        {percentiles.map((percentile) => (
          <tr key={percentile}>
            <th>{percentile} %</th>
            <DistanceCell of={of.impact} percentile={percentile} width={of.width_m} />
            <DistanceCell of={of.rollout} percentile={percentile} width={of.width_m} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Criteria({ of: { slope, criteria, width_m } }: { of: DitchAnswer }) {
  if (!slope) return null;
  return (
    <section class="slope-criteria" aria-label="Published criteria">
      <h3>Beside it</h3>
      <p class="faint">
        The slope above the toe: {numberText(slope.height_m, 3)} m to the highest release, at {fixedText(slope.angle_deg, 0)}°. This width: {fixedText(width_m, 2)} m.
      </p>
      <dl>
        {criteria.map(({ name, text, source }) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>
              {text} <span class="faint">({source})</span>
            </dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

/// The barrier, not the ditch, keeps rocks from the far edge.
function Held({ of: { beyond, held, beyond_or_held: atMost } }: { of: DitchAnswer }) {
  if (held.rocks === 0 || !beyond.share || !atMost.share) return null;
  return (
    <p class="problem warning">
      A barrier before the far edge stops or turns back {counted(held.rocks, 'rock')}. How far they would get without it is unknown: the
      ditch alone lets {percentText(beyond.share.value)} to {percentText(atMost.share.value)} get beyond.
    </p>
  );
}

function Answer({ of }: { of: DitchAnswer }) {
  const { retained, beyond, arriving, inside, held, rocks, run } = of;
  const stored = run.stored < run.rocks ? ` Trajectories of ${run.stored.toLocaleString('en')} of ${run.rocks.toLocaleString('en')} rocks are stored.` : '';
  return (
    <>
      <p class="big-share">
        <strong>{beyond.share ? percentText(beyond.share.value) : '–'}</strong> get beyond the far edge{held.rocks > 0 && ', with the barrier'}: {beyond.rocks.toLocaleString('en')} of {rocks.toLocaleString('en')}
        <span class="interval">{beyond.share && intervalText(beyond.share)}</span>
      </p>
      <Held of={of} />
      <p>
        {arriving.rocks.toLocaleString('en')} get past the toe, {inside.rocks.toLocaleString('en')} stop inside.
        {retained.share && (
          <>
            {' '}
            Of those that arrive, <strong>{percentText(retained.share.value)}</strong> ({intervalText(retained.share)}) are retained.
          </>
        )}
        {stored}
      </p>
      {of.released_beyond > 0 && <p class="faint">{of.released_beyond.toLocaleString('en')} rocks start past the toe and do not count.</p>}
      {arriving.rocks > 0 && <DistanceTable of={of} />}
      <p class="faint">
        Distances from the toe, with {Math.round(100 * of.confidence)} % confidence intervals; ?: too few rocks. Red: beyond the far edge.
      </p>
      <Criteria of={of} />
    </>
  );
}

export function StaysPane() {
  const [run, [toe, far]] = [shown.value, stretch.value];
  return (
    <>
      <p class="faint">What stays between the toe and the far edge of a ditch or bench, in the shown run. Drag both in the view, or type.</p>
      <div class="slope-numbers">
        <NumberInput title="Toe at x" unit="m" value={toe} take={(value) => value !== null && setStretch([value, far])} />
        <NumberInput title="Far edge at x" unit="m" value={far} take={(value) => value !== null && setStretch([toe, value])} />
      </div>
      {!run || !hasResults(run) ? (
        <p class="faint">Compute the project or choose a run.</p>
      ) : refused.value !== null ? (
        <p class="problem error">{refused.value}</p>
      ) : (
        <>
          {isOutdated.value && <p class="problem warning">The shown run is of an earlier state of the project. Compute it again.</p>}
          {stays.value && <Answer of={stays.value} />}
        </>
      )}
      <Compared />
    </>
  );
}
