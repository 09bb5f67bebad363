// Renders the playback of the shown run frame by frame. A frame shows its moment exactly, however long it takes to draw.

import { signal } from '@preact/signals';
import { saveFile } from '../figures/files';
import { blocksLoaded } from '../paths/drawnBlocks';
import { endTime, goTo, pause, time } from '../paths/playback';
import { file, fileStem, values } from '../project/document';
import { reportFailure } from '../state/messages';
import { shown } from '../runs/runs';
import { frameCount, lastDelay, timesOf, type Plan } from './frames';
import { Gif } from './gif';

export interface Size {
  width: number;
  height: number;
}

/// A view whose playback can be saved.
export interface AnimatedView {
  /// Loads what a picture of this size needs.
  prepare?: (size: Size) => Promise<void>;
  /// Draws the present moment, opaque, one pixel per CSS pixel.
  paint: (size: Size) => HTMLCanvasElement;
}

/// Frames that are drawn, while an animation is made.
export const progress = signal<{ done: number; of: number } | null>(null);

const headHeight = 36;
const barHeight = 4;
const [ink, faint, line] = ['#1d2326', '#5a6468', '#c8d0d4'];
const font = (size: number, weight = 400) => `${weight} ${size}px system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif`;

const titleNow = () => (typeof values.peek().name === 'string' ? (values.peek().name as string) : fileStem());
const timeText = (seconds: number, end: number) => `${seconds.toFixed(end < 10 ? 2 : 1)} s`;

/// The view below a strip with the title, the run and the time.
function frameOf(view: AnimatedView, size: Size, pen: CanvasRenderingContext2D, seconds: number): Uint8ClampedArray {
  const { width, height } = size;
  const end = endTime.peek();
  const room = { width, height: height - headHeight - barHeight };
  pen.fillStyle = '#ffffff';
  pen.fillRect(0, 0, width, height);
  pen.drawImage(view.paint(room), 0, headHeight, room.width, room.height);
  const now = timeText(seconds, end);
  pen.textBaseline = 'middle';
  pen.textAlign = 'right';
  pen.fillStyle = ink;
  pen.font = font(16, 600);
  pen.fillText(now, width - 12, headHeight / 2);
  const ofTime = pen.measureText(timeText(end, end)).width + 36;
  pen.textAlign = 'left';
  pen.fillText(titleNow(), 12, headHeight / 2, 0.6 * (width - ofTime));
  const left = 24 + Math.min(pen.measureText(titleNow()).width, 0.6 * (width - ofTime));
  pen.font = font(12);
  pen.fillStyle = faint;
  pen.fillText([`Run ${shown.peek()?.name ?? ''}`, file.peek() ?? ''].filter(Boolean).join(' · '), left, headHeight / 2 + 1, width - left - ofTime);
  pen.fillStyle = line;
  pen.fillRect(0, height - barHeight, width, barHeight);
  pen.fillStyle = ink;
  pen.fillRect(0, height - barHeight, (width * seconds) / (end || 1), barHeight);
  return pen.getImageData(0, 0, width, height).data;
}

const nextTask = () => new Promise((done) => setTimeout(done));

/// The animation; null if `stop` was requested.
async function filmed(view: AnimatedView, plan: Plan, size: Size, stop: AbortSignal): Promise<Uint8Array<ArrayBuffer> | null> {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, size);
  const pen = canvas.getContext('2d', { alpha: false, willReadFrequently: true })!;
  const at = (seconds: number) => {
    goTo(seconds);
    return frameOf(view, size, pen, seconds);
  };
  await blocksLoaded();
  await view.prepare?.(size);
  const times = timesOf(plan, endTime.peek());
  const last = times.length - 1;
  const typical: Uint8ClampedArray[] = [];
  for (const share of [0, 0.2, 0.4, 0.6, 0.8, 1]) {
    if (stop.aborted) return null;
    typical.push(at(times[Math.round(share * last)]!));
    await nextTask();
  }
  const gif = new Gif(size.width, size.height, typical);
  for (const [k, seconds] of times.entries()) {
    if (stop.aborted) return null;
    gif.add(at(seconds), k === last ? lastDelay : 1000 / plan.rate);
    progress.value = { done: k + 1, of: times.length };
    await nextTask();
  }
  return gif.finish();
}

/// Saves the playback as an animated GIF. The playback is then where it was.
export async function saveAnimation(view: AnimatedView, plan: Plan, size: Size, stop: AbortSignal) {
  pause();
  const before = time.peek();
  progress.value = { done: 0, of: frameCount(plan) };
  try {
    const film = await filmed(view, plan, size, stop);
    if (film) saveFile(`${fileStem() || 'animation'}.gif`, new Blob([film], { type: 'image/gif' }));
  } catch (error) {
    reportFailure(error);
  } finally {
    progress.value = null;
    goTo(before);
  }
}
