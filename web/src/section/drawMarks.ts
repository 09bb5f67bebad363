// Draws marks on the slope: seeders, barriers, overlays of tools and forms.

import type { Model } from '../api/types';
import type { ObservedPlaces } from '../calibration/observations';
import type { Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { markRadius, meanSpacing } from '../paths/rockSize';
import { labelOf, type Label } from '../view/labels';
import { pixelOf, type Frame } from './frame';

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

function polyline(pen: Pen, points: [number, number][], width: number, colour: string, closed = false) {
  pen.beginPath();
  points.forEach(([x, y], k) => (k === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
  if (closed) pen.closePath();
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.stroke();
}

function diamond(pen: Pen, [x, y]: [number, number], size: number) {
  const corners: [number, number][] = [
    [x, y - size],
    [x + size, y],
    [x, y + size],
    [x - size, y],
  ];
  polyline(pen, corners, 2.5, '#ffffff', true);
  pen.fillStyle = markColours.stops;
  pen.fill();
}

function cross(pen: Pen, [x, y]: [number, number], size: number) {
  const arm = 0.8 * size;
  const stroke = (width: number, colour: string) => {
    polyline(pen, [[x - arm, y - arm], [x + arm, y + arm]], width, colour);
    polyline(pen, [[x - arm, y + arm], [x + arm, y - arm]], width, colour);
  };
  stroke(4.5, '#ffffff');
  stroke(2.2, markColours.marks);
}

/// Each function draws marks and returns their labels.
export function drawSeeders(pen: Pen, frame: Frame, { seeders }: Model, chosen: string): Label[] {
  return seeders.flatMap((seeder) => {
    for (const line of seeder.lines) polyline(pen, line.map(([x, , z]) => pixelOf(frame, x, z)), 3, markColours.seeder);
    const pixels = seeder.points.map(([x, , z]) => pixelOf(frame, x, z));
    const size = markRadius(meanSpacing(pixels), seeder.path === chosen ? 7 : 5);
    for (const pixel of pixels) dot(pen, pixel, size, markColours.seeder);
    const at = pixels[Math.floor(pixels.length / 2)];
    return at ? [labelOf(pen, seeder.name, at, size + 1)] : [];
  });
}

export function drawBarriers(pen: Pen, frame: Frame, { barriers }: Model, chosen: string): Label[] {
  return barriers.flatMap((barrier) => {
    const [foot, top] = [barrier.foot[0], barrier.top[0]];
    if (!foot || !top) return [];
    const ends = [pixelOf(frame, foot[0], foot[2]), pixelOf(frame, top[0], top[2])];
    const isCollector = barrier.kind === 'collector';
    pen.setLineDash(isCollector ? [6, 4] : []);
    polyline(pen, ends, barrier.path === chosen ? 6 : 3.5, isCollector ? markColours.collector : markColours.barrier);
    pen.setLineDash([]);
    return [labelOf(pen, barrier.name, ends[1]!, 3)];
  });
}

/// Stops as diamonds, marks as crosses.
export function drawObserved(pen: Pen, frame: Frame, lists: readonly ObservedPlaces[]) {
  for (const { kind, places } of lists) {
    const pixels = places.map(([x, , z]) => pixelOf(frame, x, z));
    const size = markRadius(meanSpacing(pixels), 6) + 1;
    for (const at of pixels) (kind === 'stops' ? diamond : cross)(pen, at, size);
  }
}

/// A line up from a place of the ground, over all trajectories, with its name.
function drawPlace(pen: Pen, { height }: Frame, [x, y]: [number, number], colour: string, name: string): Label[] {
  const top = Math.max(24, y - 0.7 * height);
  polyline(pen, [[x, y], [x, top]], 7, '#ffffff'); // prettier-ignore
  pen.setLineDash([10, 5]);
  polyline(pen, [[x, y], [x, top]], 3.5, colour); // prettier-ignore
  pen.setLineDash([]);
  return [labelOf(pen, name, [x, top], 0, colour)];
}

export function drawOverlays(pen: Pen, frame: Frame, lists: Overlay[]): Label[] {
  return lists.flatMap(({ points, kind, colour = markColours.tool, label, width = 3, isBare, isDashed, place }) => {
    const pixels = points.map(([x, , z]) => pixelOf(frame, x, z));
    const named = place && pixels[0] ? drawPlace(pen, frame, pixels[0], colour, place.name) : [];
    if (kind === 'points') for (const pixel of pixels) dot(pen, pixel, 5, colour);
    else {
      pen.setLineDash(isDashed ? [8, 5] : []);
      polyline(pen, pixels, width, colour, kind === 'polygon');
      pen.setLineDash([]);
    }
    if (kind !== 'points' && !isBare) for (const pixel of pixels) dot(pen, pixel, 3.5, colour);
    const last = pixels.at(-1);
    return [...named, ...(label && last ? [labelOf(pen, label, last, 5)] : [])];
  });
}
