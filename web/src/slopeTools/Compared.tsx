// The retained share before and after a tool.

import type { DitchShare } from '../api/ditch';
import { intervalText, percentText } from '../askLine/kit';
import { fixedText } from '../units/numbers';
import { comparing, comparison } from './compare';

export function ShareCell({ of: { share } }: { of: DitchShare }) {
  return (
    <td>
      {share ? (
        <>
          <strong>{percentText(share.value)}</strong>
          <span class="interval">{intervalText(share)}</span>
        </>
      ) : (
        '–'
      )}
    </td>
  );
}

export function Compared() {
  const [state, found] = [comparing.value, comparison.value];
  if (state === 'running') return <p class="faint">Two runs are under way; they stay in the list of runs.</p>;
  if (state) return <p class="problem error">{state.failed}</p>;
  if (!found) return null;
  const { before, after, rocks, stretch, title } = found;
  const [toe, far] = stretch.map((x) => fixedText(x, 2));
  return (
    <figure class="slope-compared" aria-label="Retained share before and after">
      <table>
        <thead>
          <tr>
            <th />
            <th>Before</th>
            <th>With the {title}</th>
          </tr>
        </thead>
        <tbody>
          <tr>
            <th>Do not get beyond x {far} m</th>
            <ShareCell of={before.kept} />
            <ShareCell of={after.kept} />
          </tr>
          <tr>
            <th>
              Stop from x {toe} to {far} m
            </th>
            <ShareCell of={before.inside} />
            <ShareCell of={after.inside} />
          </tr>
        </tbody>
      </table>
      <figcaption class="faint">
        The same {rocks.toLocaleString('en')} rocks with the same seed on both slopes, a small run for comparing; {Math.round(100 * before.confidence)} % confidence intervals.
      </figcaption>
    </figure>
  );
}
