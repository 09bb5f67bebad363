// The answers while no place is chosen: how far rocks go, and how to choose one.

import type { NumberText } from '../api/exact';
import type { Summary } from '../api/results';
import { ask } from '../askLine/asked';
import { drawAsked } from '../askLine/askTools';
import { askLongContour } from '../askLine/fromMap';
import { shownPaths } from '../paths/drawnPaths';
import { shown } from '../runs/runs';
import { displayOf } from '../state/displayUnits';
import { attempt } from '../state/messages';
import { numberText } from '../units/numbers';
import { leaving } from './leaving';
import { middleEnd, middleEnds, spreadOf } from './middleEnd';

function Figure({ title, value, note }: { title: string; value: string; note: string }) {
  return (
    <section class="answer-card" aria-label={title}>
      <h3>{title}</h3>
      <p>
        <strong>{value}</strong>
      </p>
      <p class="faint note">{note}</p>
    </section>
  );
}

function percentileIn(of: Summary, key: string, metric: string): string {
  const found = Number((of.statistics[key]?.percentiles as Record<string, NumberText> | undefined)?.['95']);
  const { unit, per } = displayOf(metric);
  return Number.isFinite(found) ? `${numberText(found / per, 3)} ${unit}` : 'none';
}

/// Asks where half of the rocks stop: in a section that place, in 3D a contour through an end about the middle one that is
/// as long as the ends are spread. That through the middle end itself may be a few metres around a hollow.
const takeMiddle = () =>
  attempt('the place', async () => {
    const paths = shownPaths.peek();
    const end = paths && middleEnd(paths);
    if (!end) return;
    if (shown.peek()?.dimension === 2) ask({ kind: 'line', points: [[Number(end[0].toFixed(2)), 0]] }, 'ask where half of the rocks stop', false);
    else await askLongContour(middleEnds(paths), spreadOf(middleEnds(paths)));
  });

export function NoPlace({ of }: { of: Summary }) {
  const is2d = shown.value?.dimension === 2;
  const leave = leaving(of.end_reasons, of.rocks.done);
  return (
    <div class="answer-cards">
      <section class="answer-card choose-place" aria-label="Choose a place">
        <h3>Where must rocks not pass?</h3>
        <p class="choose-text">{is2d ? 'Pick the road, or any place that rocks must not pass.' : 'Draw the road, or any line that rocks must not pass.'}</p>
        <div class="choices">
          <button class="button first" onClick={() => drawAsked('line')}>
            {is2d ? 'Pick the place' : 'Draw the line'}
          </button>
          <button
            class="button"
            disabled={!shownPaths.value || shownPaths.value.rocks.length === 0}
            title={is2d ? 'The place where half of the drawn rocks have stopped' : 'A contour through a place where about half of the drawn rocks have stopped'}
            onClick={() => void takeMiddle()}
          >
            {is2d ? 'Where half of them stop' : 'Contour of the middle end'}
          </button>
        </div>
      </section>
      <Figure title="95 % of the rocks stop within" value={percentileIn(of, 'runout_xy_m', 'm')} note="of their release, on plan" />
      <Figure title="Leave the model" value={leave.share} note={leave.note} />
      <Figure title="95 % of the largest energies" value={percentileIn(of, 'max_ke_J', 'J')} note="total, anywhere on the way" />
    </div>
  );
}
