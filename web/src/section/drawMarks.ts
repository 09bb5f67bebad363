// What stands on the slope: seeders, barriers, what tools and forms show.

import type { Model } from '../api/types';
import type { Overlay } from '../scene/tool';
import { markColours } from '../view/colours';
import { pixelOf, type Frame } from './frame';
import type { Look } from './drawGround';

type Pen = CanvasRenderingContext2D;

function dot(pen: Pen, [x, y]: [number, number], size: number, colour: string) {
  pen.beginPath();
  pen.arc(x, y, size, 0, 2 * Math.PI);
  pen.fillStyle = colour;
  pen.fill();
  pen.lineWidth = 1.5;
  pen.strokeStyle = '#ffffff';
  pen.stroke();
}

function name(pen: Pen, text: string, [x, y]: [number, number], look: Look) {
  pen.font = '600 12px system-ui, sans-serif';
  pen.textAlign = 'center';
  pen.textBaseline = 'bottom';
  pen.lineWidth = 3.5;
  pen.strokeStyle = look.panel;
  pen.strokeText(text, x, y);
  pen.fillStyle = look.text;
  pen.fillText(text, x, y);
}

function polyline(pen: Pen, points: [number, number][], width: number, colour: string, closed = false) {
  pen.beginPath();
  points.forEach(([x, y], k) => (k === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
  if (closed) pen.closePath();
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.stroke();
}

export function drawSeeders(pen: Pen, frame: Frame, { seeders }: Model, look: Look, chosen: string) {
  for (const seeder of seeders) {
    for (const line of seeder.lines) polyline(pen, line.map(([x, , z]) => pixelOf(frame, x, z)), 3, markColours.seeder);
    for (const [x, , z] of seeder.points) dot(pen, pixelOf(frame, x, z), seeder.path === chosen ? 7 : 5, markColours.seeder);
    const first = seeder.points[0];
    if (!first) continue;
    const [x, y] = pixelOf(frame, first[0], first[2]);
    name(pen, seeder.name, [x, y - 9], look);
  }
}

export function drawBarriers(pen: Pen, frame: Frame, { barriers }: Model, look: Look, chosen: string) {
  for (const barrier of barriers) {
    const [foot, top] = [barrier.foot[0], barrier.top[0]];
    if (!foot || !top) continue;
    const ends = [pixelOf(frame, foot[0], foot[2]), pixelOf(frame, top[0], top[2])];
    const isCollector = barrier.kind === 'collector';
    pen.setLineDash(isCollector ? [6, 4] : []);
    polyline(pen, ends, barrier.path === chosen ? 6 : 3.5, isCollector ? markColours.collector : markColours.barrier);
    pen.setLineDash([]);
    name(pen, barrier.name, [ends[1]![0], ends[1]![1] - 5], look);
  }
}

export function drawOverlays(pen: Pen, frame: Frame, lists: Overlay[], look: Look) {
  for (const { points, kind, colour = markColours.tool, label } of lists) {
    const pixels = points.map(([x, , z]) => pixelOf(frame, x, z));
    if (kind === 'points') for (const pixel of pixels) dot(pen, pixel, 5, colour);
    else polyline(pen, pixels, 3, colour, kind === 'polygon');
    if (kind !== 'points') for (const pixel of pixels) dot(pen, pixel, 3.5, colour);
    const last = pixels.at(-1);
    if (label && last) name(pen, label, [last[0], last[1] - 8], look);
  }
}
