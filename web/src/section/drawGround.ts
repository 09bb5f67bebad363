// The slope, its grid and axes, on a canvas whose unit is a CSS pixel.

import { materialColour } from '../view/colours';
import { roundStep, tickText, ticks } from '../view/ticks';
import { pixelOf, placeOf, type Frame } from './frame';
import type { Profile } from './profile';

export interface Look {
  text: string;
  faint: string;
  line: string;
  panel: string;
  ground: string;
  accent: string;
}

const tickDistance = 70; // at least so many pixels

export function drawGrid(pen: CanvasRenderingContext2D, frame: Frame, look: Look) {
  const [left, high] = placeOf(frame, 0, 0);
  const [right, low] = placeOf(frame, frame.width, frame.height);
  const stepX = roundStep(tickDistance / frame.along);
  const stepZ = roundStep((0.7 * tickDistance) / frame.up);
  pen.lineWidth = 1;
  pen.strokeStyle = look.line;
  pen.globalAlpha = 0.55;
  pen.beginPath();
  for (const x of ticks(left, right, stepX)) {
    const [at] = pixelOf(frame, x, 0);
    pen.moveTo(Math.round(at) + 0.5, 0);
    pen.lineTo(Math.round(at) + 0.5, frame.height);
  }
  for (const z of ticks(low, high, stepZ)) {
    const [, at] = pixelOf(frame, 0, z);
    pen.moveTo(0, Math.round(at) + 0.5);
    pen.lineTo(frame.width, Math.round(at) + 0.5);
  }
  pen.stroke();
  pen.globalAlpha = 1;
}

export function drawAxes(pen: CanvasRenderingContext2D, frame: Frame, look: Look) {
  const [left, high] = placeOf(frame, 0, 0);
  const [right, low] = placeOf(frame, frame.width, frame.height);
  const stepX = roundStep(tickDistance / frame.along);
  const stepZ = roundStep((0.7 * tickDistance) / frame.up);
  const bottom = frame.height - 30;
  pen.font = '11px system-ui, sans-serif';
  const label = (words: string, x: number, y: number) => {
    pen.lineWidth = 3;
    pen.strokeStyle = look.panel;
    pen.strokeText(words, x, y);
    pen.fillStyle = look.faint;
    pen.fillText(words, x, y);
  };
  pen.textAlign = 'center';
  pen.textBaseline = 'bottom';
  for (const x of ticks(left, right, stepX)) {
    const [at] = pixelOf(frame, x, 0);
    if (at > 60 && at < frame.width - 40) label(tickText(x, stepX), at, bottom);
  }
  label('x, m', frame.width - 22, bottom);
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  for (const z of ticks(low, high, stepZ)) {
    const [, at] = pixelOf(frame, 0, z);
    if (at > 70 && at < bottom - 20) label(tickText(z, stepZ), 8, at);
  }
  label('z, m', 8, 58);
}

/// The ground as a body, and each segment in the colour of its material.
export function drawSlope(pen: CanvasRenderingContext2D, frame: Frame, profile: Profile, look: Look) {
  const points = profile.vertices.map(([x, z]) => pixelOf(frame, x, z));
  const first = points[0];
  const last = points.at(-1);
  if (!first || !last) return;
  pen.beginPath();
  pen.moveTo(first[0], frame.height);
  for (const [x, y] of points) pen.lineTo(x, y);
  pen.lineTo(last[0], frame.height);
  pen.closePath();
  pen.fillStyle = look.ground;
  pen.fill();

  pen.lineCap = 'round';
  profile.materials.forEach((material, k) => {
    const [a, b] = [points[k], points[k + 1]];
    if (!a || !b) return;
    for (const [width, colour] of [[6, materialColour(material)], [1.2, look.text]] as const) {
      pen.lineWidth = width;
      pen.strokeStyle = colour;
      pen.beginPath();
      pen.moveTo(...a);
      pen.lineTo(...b);
      pen.stroke();
    }
  });
  if (points.length > 200) return;
  pen.fillStyle = look.text;
  for (const [x, y] of points) {
    pen.beginPath();
    pen.arc(x, y, 2.5, 0, 2 * Math.PI);
    pen.fill();
  }
}
