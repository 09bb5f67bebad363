// The playback time of the rocks. All rocks are released at time 0.

import { computed, effect, signal, untracked } from '@preact/signals';
import { startedHere } from '../runs/runs';
import { kept } from '../state/kept';
import { owned } from '../state/owned';
import { shownPaths } from './drawnPaths';

export const speeds = [0.25, 0.5, 1, 2, 4, 8];
/// Simulated seconds per second of playback.
export const [playbackSpeed, setSpeed] = owned(kept('view playback speed', 1));

/// The time at which the last rock stops [s].
export const endTime = computed(() => {
  const paths = shownPaths.value;
  let end = 0;
  if (paths) for (const start of paths.starts.subarray(1)) end = Math.max(end, paths.times[start - 1] ?? 0);
  return end;
});

const moment = signal(Infinity);
/// Trajectories are drawn up to this time [s]. At `endTime` they are complete, and moving rocks are not drawn.
export const time = computed(() => Math.min(moment.value, endTime.value));
export const isPlaying = signal(false);
export const isWhole = computed(() => !isPlaying.value && time.value >= endTime.value);

const wantsLessMotion = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

export function play() {
  if (endTime.value === 0) return;
  if (time.value >= endTime.value) moment.value = 0;
  isPlaying.value = true;
}
export const pause = () => void (isPlaying.value = false);
/// Moves to a time. The end is kept if another run is longer.
export function goTo(seconds: number) {
  moment.value = seconds >= endTime.value ? Infinity : Math.max(0, seconds);
}

/// A task that sees complete trajectories; then the playback is as before.
export async function withWhole<T>(task: () => Promise<T>): Promise<T> {
  const [seconds, wasPlaying] = [time.peek(), isPlaying.peek()];
  pause();
  goTo(Infinity);
  try {
    return await task();
  } finally {
    goTo(seconds);
    isPlaying.value = wasPlaying;
  }
}

const longestStep = 0.1; // s; after the page was hidden, playback continues where it was
let frame = 0;
let before = 0;
function step(now: number) {
  const next = time.peek() + Math.min(longestStep, (now - before) / 1000) * playbackSpeed.peek();
  before = now;
  goTo(next);
  if (next >= endTime.peek()) isPlaying.value = false;
  else frame = requestAnimationFrame(step);
}
effect(() => {
  cancelAnimationFrame(frame);
  if (!isPlaying.value) return;
  before = performance.now();
  frame = requestAnimationFrame(step);
});

// New trajectories are shown complete; those of a run started on this page are played once.
effect(() => {
  const paths = shownPaths.value;
  if (paths?.header.so_far) return; // it is shown up to the time of those before
  isPlaying.value = false;
  moment.value = Infinity;
  if (paths && startedHere.delete(paths.run) && !wantsLessMotion()) untracked(play);
});
