// Draws the slope, grid and axes on a canvas in CSS pixels.

import { materialColour } from '../view/colours';
import { overlap, type Box } from '../geometry/framing';
import { tickText } from '../units/numbers';
import { roundStep, ticks } from '../geometry/ticks';
import { pixelOf, placeOf, type Frame } from './frame';
import type { Profile } from '../project/profile';

export interface Look {
  text: string;
  faint: string;
  line: string;
  panel: string;
  ground: string;
  accent: string;
}

const tickDistance = 70; // minimum, pixels

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

/// Draws numbers along the left and lower sides, except where something covers them. Returns their boxes.
export function drawAxes(pen: CanvasRenderingContext2D, frame: Frame, look: Look, covered: readonly Box[]): Box[] {
  const [left, high] = placeOf(frame, 0, 0);
  const [right, low] = placeOf(frame, frame.width, frame.height);
  const stepX = roundStep(tickDistance / frame.along);
  const stepZ = roundStep((0.7 * tickDistance) / frame.up);
  // Above the strip along the lower edge, which is higher while it has the hint of a tool.
  const strips = covered.filter((box) => box.left <= 0 && box.right >= frame.width && box.bottom >= frame.height);
  const bottom = Math.min(frame.height - 30, ...strips.map((box) => box.top));
  pen.font = '11px system-ui, sans-serif';
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  const taken: Box[] = [];
  const label = (words: string, x: number, middle: number, isCentred: boolean) => {
    const { width } = pen.measureText(words);
    const from = isCentred ? x - width / 2 : x;
    const box = { left: from - 2, top: middle - 7, right: from + width + 2, bottom: middle + 7 };
    if (from < 2 || box.right > frame.width || [...covered, ...taken].some((other) => overlap(box, other))) return false;
    taken.push(box);
    pen.lineWidth = 3;
    pen.strokeStyle = look.panel;
    pen.strokeText(words, from, middle);
    pen.fillStyle = look.faint;
    pen.fillText(words, from, middle);
    return true;
  };
  label('x, m', frame.width - 34, bottom - 7, false);
  for (const x of ticks(left, right, stepX)) label(tickText(x, stepX), pixelOf(frame, x, 0)[0], bottom - 7, true);
  const heights = ticks(low, high, stepZ).map((z) => ({ z, at: pixelOf(frame, 0, z)[1] }));
  for (const { z, at } of heights) if (at < bottom - 20) label(tickText(z, stepZ), 8, at, false);
  // The axis label is above the numbers, or below them if that is covered.
  const numbers = taken.filter((box) => box.left < 10);
  const [top, foot] = [Math.min(...numbers.map((box) => box.top), bottom), Math.max(...numbers.map((box) => box.bottom), 0)];
  if (!label('z, m', 8, top - 9, false)) label('z, m', 8, foot + 8, false);
  return taken;
}

/// Draws the ground, with each segment in the colour of its material.
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
