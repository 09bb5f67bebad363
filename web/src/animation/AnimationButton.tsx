// Saving the playback as an animation: the choices, and the progress while it is made.

import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { shownPaths } from '../paths/drawnPaths';
import { endTime } from '../paths/playback';
import { Dialog } from '../ui/Dialog';
import { numberText } from '../units/numbers';
import { progress, saveAnimation, type AnimatedView } from './film';
import './animation.css';
import { frameCount, mostFrames, rates, sizes, usualSeconds } from './frames';

function AnimationDialog({ view, close }: { view: AnimatedView; close: () => void }) {
  const seconds = useSignal(usualSeconds(endTime.value));
  const rate = useSignal(rates[1]!);
  const size = useSignal(sizes[1]!);
  const stopping = useRef(new AbortController());
  useEffect(() => () => stopping.current.abort(), []);
  const plan = { seconds: seconds.value, rate: rate.value };
  const frames = frameCount(plan);
  const isPossible = Number.isFinite(seconds.value) && seconds.value > 0 && frames <= mostFrames;
  const now = progress.value;
  async function start() {
    await saveAnimation(view, plan, size.value, stopping.current.signal);
    close();
  }
  if (now)
    return (
      <Dialog title="Saving the animation" close={close}>
        <p>
          Frame {now.done} of {now.of}
        </p>
        <progress class="frames" value={now.done} max={now.of} aria-label="Frames" />
        <div class="choices">
          <button class="button" onClick={close}>
            Cancel
          </button>
        </div>
      </Dialog>
    );
  return (
    <Dialog title="Save the animation" close={close}>
      <div class="animation-choices">
        <label>
          Duration
          <span>
            <input
              type="number"
              min={1}
              max={120}
              step={1}
              value={seconds.value}
              onInput={(event) => (seconds.value = event.currentTarget.valueAsNumber)}
            />{' '}
            s
          </span>
        </label>
        <label>
          Frames per second
          <select value={rate.value} onChange={(event) => (rate.value = Number(event.currentTarget.value))}>
            {rates.map((each) => (
              <option key={each} value={each}>
                {each}
              </option>
            ))}
          </select>
        </label>
        <label>
          Size
          <select value={size.value.width} onChange={(event) => (size.value = sizes.find(({ width }) => width === Number(event.currentTarget.value))!)}>
            {sizes.map(({ width, height }) => (
              <option key={width} value={width}>
                {width} × {height}
              </option>
            ))}
          </select>
        </label>
      </div>
      <p class="faint">
        {isPossible
          ? `${frames} frames, at ${numberText(Number((endTime.value / seconds.value).toPrecision(2)))} times the speed of the rocks. An animated GIF, for reports, slides and browsers.`
          : `Choose a duration above 0 s with at most ${mostFrames} frames.`}
      </p>
      <div class="choices">
        <button class="button" onClick={close}>
          Cancel
        </button>
        <button class="button first" disabled={!isPossible} onClick={() => void start()}>
          Save
        </button>
      </div>
    </Dialog>
  );
}

/// Shown while there are trajectories to play.
export function AnimationButton({ view }: { view: AnimatedView }) {
  const isOpen = useSignal(false);
  if (!shownPaths.value || endTime.value === 0) return null;
  return (
    <>
      <button class="button" title="Save the moving rocks as an animated GIF" onClick={() => (isOpen.value = true)}>
        Animation
      </button>
      {isOpen.value && <AnimationDialog view={view} close={() => (isOpen.value = false)} />}
    </>
  );
}
