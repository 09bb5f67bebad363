// Playback of the shown run, synchronized between views.

import { counted, numberText } from '../units/numbers';
import { shownPaths, type SoFar } from './drawnPaths';
import { endTime, goTo, isPlaying, pause, play, playbackSpeed, setSpeed, speeds, time } from './playback';
import './timeBar.css';

function key(event: KeyboardEvent) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLSelectElement) return;
  if (event.key !== ' ' || event.target instanceof HTMLButtonElement) return;
  event.preventDefault();
  if (isPlaying.value) pause();
  else play();
}

/// Of a run in progress, whose trajectories are not complete.
function Growing({ of }: { of: SoFar }) {
  return (
    <p class="time-bar growing" role="status">
      <progress max={of.planned} value={of.done} aria-hidden="true" />
      In progress: some of the trajectories of the first {of.done.toLocaleString('en')} of {counted(of.planned, 'rock')}
    </p>
  );
}

export function TimeBar() {
  const soFar = shownPaths.value?.header.so_far;
  if (soFar) return <Growing of={soFar} />;
  if (!shownPaths.value || endTime.value === 0) return null;
  const [now, end] = [time.value, endTime.value];
  const text = `${now.toFixed(end < 10 ? 2 : 1)} of ${end.toFixed(end < 10 ? 2 : 1)} s`;
  return (
    <div class="time-bar" role="group" aria-label="Playback" onKeyDown={key}>
      <button class="button" aria-label={isPlaying.value ? 'Pause' : 'Play'} title={isPlaying.value ? 'Pause' : 'Play the rocks'} onClick={isPlaying.value ? pause : play}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <path d={isPlaying.value ? 'M3 2h4v12H3zM9 2h4v12H9z' : 'M3 2l11 6-11 6z'} />
        </svg>
      </button>
      <input
        type="range"
        aria-label="Time"
        aria-valuetext={text}
        title="Space plays, arrow keys step"
        min={0}
        max={end}
        step="any"
        value={now}
        onInput={(event) => {
          pause();
          goTo(Number(event.currentTarget.value));
        }}
      />
      <output class="mono">{text}</output>
      <select
        aria-label="Playback speed"
        value={playbackSpeed.value}
        onChange={(event) => setSpeed(Number(event.currentTarget.value))}
      >
        {speeds.map((factor) => (
          <option key={factor} value={factor}>
            {numberText(factor)}×
          </option>
        ))}
      </select>
    </div>
  );
}
