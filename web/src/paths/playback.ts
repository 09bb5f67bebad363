// The moment at which the rocks are shown. All rocks set out at time 0, as each in its path.

import { computed, effect, signal, untracked } from '@preact/signals';
import { startedHere } from '../state/runs';
import { playbackSpeed } from '../view/settings';
import { shownPaths } from './drawnPaths';

export const speeds = [0.25, 0.5, 1, 2, 4, 8];

/// When the last rock stops, s.
export const endTime = computed(() => {
  const paths = shownPaths.value;
  let end = 0;
  if (paths) for (const start of paths.starts.subarray(1)) end = Math.max(end, paths.times[start - 1] ?? 0);
  return end;
});

const moment = signal(Infinity);
/// Paths are drawn up to it, s; at `endTime` they are whole, and the rocks are not drawn.
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
/// Stays at the end when the end is chosen.
export function goTo(seconds: number) {
  moment.value = seconds >= endTime.value ? Infinity : Math.max(0, seconds);
}

const longestStep = 0.1; // s; a page that was hidden goes on where it was
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

// Other paths are shown whole first; those of a run that was started here are seen in motion, once.
effect(() => {
  const paths = shownPaths.value;
  isPlaying.value = false;
  moment.value = Infinity;
  if (paths && startedHere.delete(paths.run) && !wantsLessMotion()) untracked(play);
});
