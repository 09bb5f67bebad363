// Legends as data, shown over a view and drawn into saved pictures.

import { numberText } from '../units/numbers';
import { cssOf, type Colour, type Ramp } from './colours';

export interface ScaleOfColours {
  kind: 'scale';
  title: string; // with the unit
  /// Positions from 0 to 1, and their colours.
  stops: readonly (readonly [number, string])[];
  low: number;
  high: number;
  /// Whether higher values have the last colour.
  isClipped: boolean;
}
export interface KindsOfThings {
  kind: 'kinds';
  title: string;
  kinds: { name: string; colour: string }[];
}
export interface ClassesOfValues {
  kind: 'classes';
  title: string;
  /// The lowest first.
  classes: { text: string; colour: string; isUsed: boolean }[];
  note: string;
}
export interface Remark {
  kind: 'remark';
  text: string;
  isWarning: boolean;
}
export type LegendData = ScaleOfColours | KindsOfThings | ClassesOfValues | Remark;

export const stopsOf = (ramp: Ramp): [number, string][] => ramp.map(([at, colour]: [number, Colour]) => [at, cssOf(colour)]);
/// The numbers below a scale.
export const endsOf = ({ low, high, isClipped }: ScaleOfColours): string[] => [
  numberText(low, 3),
  numberText((low + high) / 2, 3),
  `${isClipped ? '≥ ' : ''}${numberText(high, 3)}`,
];

type Pen = CanvasRenderingContext2D;
const ink = '#1d2326';
const faint = '#5a6468';
const font = (size: number, weight = 400) => `${weight} ${size}px system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif`;

/// Wraps a text into lines of at most `width` pixels.
export function linesOf(pen: Pen, text: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (lines.length > 0 && pen.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

function words(pen: Pen, text: string, x: number, y: number, width: number, lineHeight: number): number {
  for (const line of linesOf(pen, text, width)) pen.fillText(line, x, (y += lineHeight) - 0.25 * lineHeight, width);
  return y;
}

function swatch(pen: Pen, colour: string, x: number, y: number, width: number, height: number) {
  pen.fillStyle = colour;
  pen.fillRect(x, y, width, height);
  pen.lineWidth = 0.6;
  pen.strokeStyle = faint;
  pen.strokeRect(x, y, width, height);
}

function drawScale(pen: Pen, scale: ScaleOfColours, x: number, y: number, width: number): number {
  const gradient = pen.createLinearGradient(x, 0, x + width, 0);
  for (const [at, colour] of scale.stops) gradient.addColorStop(at, colour);
  pen.fillStyle = gradient;
  pen.fillRect(x, y + 4, width, 10);
  pen.fillStyle = ink;
  pen.font = font(10.5);
  endsOf(scale).forEach((text, k) => {
    pen.textAlign = (['left', 'center', 'right'] as const)[k]!;
    pen.fillText(text, x + (k * width) / 2, y + 26);
  });
  pen.textAlign = 'left';
  return y + 30;
}

function drawList(pen: Pen, list: readonly { text: string; colour: string; isUsed?: boolean }[], x: number, y: number, width: number): number {
  pen.font = font(11);
  for (const { text, colour, isUsed = true } of list) {
    swatch(pen, colour, x, y + 3, 20, 12);
    pen.fillStyle = isUsed ? ink : faint;
    pen.fillText(text, x + 28, y + 13, width - 28);
    y += 16;
  }
  return y;
}

/// Draws legends one below the other. Returns the y of their end.
export function drawLegends(pen: Pen, list: readonly LegendData[], x: number, y: number, width: number): number {
  pen.textAlign = 'left';
  pen.textBaseline = 'alphabetic';
  for (const legend of list) {
    pen.fillStyle = ink;
    if (legend.kind === 'remark') {
      pen.font = font(11, legend.isWarning ? 600 : 400);
      y = words(pen, legend.text, x, y, width, 15) + 12;
      continue;
    }
    pen.font = font(12, 600);
    y = words(pen, legend.title, x, y, width, 16);
    if (legend.kind === 'scale') y = drawScale(pen, legend, x, y, width);
    if (legend.kind === 'kinds') y = drawList(pen, legend.kinds.map(({ name, colour }) => ({ text: name, colour })), x, y, width);
    if (legend.kind === 'classes') {
      y = drawList(pen, legend.classes.toReversed(), x, y, width);
      pen.fillStyle = faint;
      pen.font = font(10.5);
      y = words(pen, legend.note, x, y, width, 15);
    }
    y += 14;
  }
  return y;
}
