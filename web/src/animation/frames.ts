// The frames of an animation: which moments of the playback they show, and for how long.

export interface Plan {
  /// Duration of the animation [s], without the last frame.
  seconds: number;
  /// Frames per second.
  rate: number;
}

/// Frame rates whose delays are whole hundredths of a second, as GIF keeps them.
export const rates = [10, 20, 25];
export const sizes = [
  { width: 640, height: 360 },
  { width: 960, height: 540 },
  { width: 1280, height: 720 },
];
/// How long the last frame stays, with all trajectories and end points [ms].
export const lastDelay = 2000;
export const mostFrames = 1500;

export const frameCount = ({ seconds, rate }: Plan) => Math.max(2, Math.round(seconds * rate) + 1);

/// The playback times of the frames [s]: evenly spread from 0 to `end`, which is the last one exactly.
export function timesOf(plan: Plan, end: number): number[] {
  const count = frameCount(plan);
  return Array.from({ length: count }, (_, k) => (k === count - 1 ? end : (end * k) / (count - 1)));
}

/// A duration to begin with: real time, but no shorter than 4 s and no longer than 20 s.
export const usualSeconds = (end: number) => Math.round(Math.min(20, Math.max(4, end)));
