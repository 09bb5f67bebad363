// A picture for print: a sheet with title, legends, scale bar, north arrow and source.

import { about } from '../state/about';
import { file, fileStem, values } from '../project/document';
import { isTable } from '../settings/tables';
import { model } from '../project/model';
import { reportFailure } from '../state/messages';
import { hasResults, shown } from '../runs/runs';
import { saveFile } from '../figures/files';
import { counted, numberText } from '../units/numbers';
import { drawLegends, type LegendData } from './legends';
import { printPng, printRatio } from '../figures/png';
import { roundStep } from '../geometry/ticks';

/// A landscape A4 page without its margins, 267 mm by 180 mm, in CSS pixels.
const sheet = { width: 1009, height: 680 };
const margin = 14;
const columnWidth = 190;
const frame = { left: margin, top: 62, width: sheet.width - 3 * margin - columnWidth, height: sheet.height - 62 - 34 };
/// The size of the picture on the sheet, in CSS pixels.
export const pictureSize = { width: frame.width, height: frame.height };

export interface SheetPicture {
  /// The picture of `pictureSize`, in pixels of the print.
  canvas: HTMLCanvasElement;
  legends: readonly LegendData[];
  /// Metres per CSS pixel; null if they vary.
  metresPerPixel: number | null;
  /// The view direction in degrees from north, clockwise; null if there is no north.
  heading: number | null;
  /// Further remarks.
  remarks: readonly string[];
}

type Pen = CanvasRenderingContext2D;
const [ink, faint] = ['#1d2326', '#5a6468'];
const font = (size: number, weight = 400) => `${weight} ${size}px system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif`;

/// The length of a scale bar of at most `maximum` pixels, a round number of metres.
export function barLength(metresPerPixel: number, maximum: number): number {
  const metres = roundStep(0.4 * maximum * metresPerPixel);
  return metres / metresPerPixel > maximum ? metres / 2 : metres;
}

function drawScaleBar(pen: Pen, metresPerPixel: number, x: number, y: number): number {
  const metres = barLength(metresPerPixel, 170);
  const length = metres / metresPerPixel;
  for (let k = 0; k < 4; ++k) {
    pen.fillStyle = k % 2 === 0 ? ink : '#ffffff';
    pen.fillRect(x + (k * length) / 4, y, length / 4, 6);
  }
  pen.strokeStyle = ink;
  pen.lineWidth = 0.8;
  pen.strokeRect(x, y, length, 6);
  pen.fillStyle = ink;
  pen.font = font(10.5);
  const unit = metres >= 1000 ? { per: 1000, name: 'km' } : { per: 1, name: 'm' };
  for (const share of length > 110 ? [0, 0.5, 1] : [0, 1]) {
    pen.textAlign = share === 0 ? 'left' : share === 1 ? 'right' : 'center';
    const text = numberText((share * metres) / unit.per);
    pen.fillText(share === 1 ? `${text} ${unit.name}` : text, x + share * length, y + 18);
  }
  pen.textAlign = 'left';
  return y + 26;
}

/// Draws a north arrow of some 40 pixels around a point.
function drawNorth(pen: Pen, heading: number, x: number, y: number) {
  pen.save();
  pen.translate(x, y);
  pen.rotate((-heading * Math.PI) / 180);
  for (const side of [-1, 1]) {
    pen.beginPath();
    pen.moveTo(0, -20);
    pen.lineTo(8 * side, 9);
    pen.lineTo(0, 4);
    pen.closePath();
    pen.fillStyle = side < 0 ? ink : '#ffffff';
    pen.fill();
    pen.lineWidth = 1;
    pen.strokeStyle = ink;
    pen.stroke();
  }
  pen.fillStyle = ink;
  pen.font = font(12, 700);
  pen.textAlign = 'center';
  pen.fillText('N', 0, 23);
  pen.restore();
}

export const projectTitle = () => (typeof values.peek().name === 'string' ? (values.peek().name as string) : fileStem());

/// The title block of the report; what is not given is empty.
export function titleBlock(): Record<'client' | 'project' | 'number' | 'revision' | 'author' | 'checked' | 'date' | 'text', string> {
  const block = values.peek().report;
  const of = (key: string) => (isTable(block) && typeof block[key] === 'string' ? (block[key] as string) : '');
  return { client: of('client'), project: of('project'), number: of('number'), revision: of('revision'), author: of('author'), checked: of('checked'), date: of('date'), text: of('text') };
}

/// What identifies the work.
export function titleBlockFacts(): string[] {
  const { client, project, number, revision, author } = titleBlock();
  return [client, project, number, revision && `Rev. ${revision}`, author].filter(Boolean);
}

function drawWords(pen: Pen, remarks: readonly string[]) {
  pen.fillStyle = ink;
  pen.textBaseline = 'alphabetic';
  pen.font = font(19, 600);
  pen.fillText(projectTitle(), margin, 30, sheet.width - 2 * margin);
  const run = shown.peek();
  const ofRun = run && hasResults(run) ? [`Run ${run.name}: ${counted(run.done, 'rock')}`] : [];
  pen.font = font(12);
  pen.fillStyle = faint;
  pen.fillText([...ofRun, ...remarks].join(' · '), margin, 50, sheet.width - 2 * margin);
  const crs = model.peek()?.crs;
  const facts = [...titleBlockFacts(), file.peek() ?? '', ...(crs ? [`coordinates: ${crs}`] : []), new Date().toISOString().slice(0, 10), `Talus ${about.peek()?.version ?? ''}`];
  pen.font = font(10.5);
  pen.fillText(facts.join(' · '), margin, sheet.height - 12, sheet.width - 2 * margin);
}

/// Draws the whole sheet, opaque.
export function sheetOf({ canvas, legends, metresPerPixel, heading, remarks }: SheetPicture): HTMLCanvasElement {
  const made = document.createElement('canvas');
  Object.assign(made, { width: Math.round(sheet.width * printRatio), height: Math.round(sheet.height * printRatio) });
  const pen = made.getContext('2d', { alpha: false, willReadFrequently: true })!;
  pen.setTransform(printRatio, 0, 0, printRatio, 0, 0);
  pen.fillStyle = '#ffffff';
  pen.fillRect(0, 0, sheet.width, sheet.height);
  drawWords(pen, remarks);
  pen.drawImage(canvas, frame.left, frame.top, frame.width, frame.height);
  pen.strokeStyle = ink;
  pen.lineWidth = 0.8;
  pen.strokeRect(frame.left, frame.top, frame.width, frame.height);

  const x = frame.left + frame.width + margin;
  let y = frame.top;
  if (heading !== null) {
    drawNorth(pen, heading, x + 22, y + 24);
    y += 62;
  }
  if (metresPerPixel !== null) y = drawScaleBar(pen, metresPerPixel, x, y + 4) + 14;
  drawLegends(pen, legends, x, y, columnWidth);
  return made;
}

/// `mustShowPlace`: if the place of the answers is out of view, the picture shows all of the result.
type PaintSheet = (mustShowPlace: boolean) => SheetPicture | Promise<SheetPicture>;
/// Paints the open view; null: there is none.
let paintView: PaintSheet | null = null;

/// A view that is open offers its picture. Returns a function that ends this.
export function offerSheet(paint: PaintSheet): () => void {
  paintView = paint;
  return () => {
    if (paintView === paint) paintView = null;
  };
}

/// The sheet of the open view.
export const sheetPng = async (mustShowPlace = false): Promise<Blob | null> => (paintView ? printPng(sheetOf(await paintView(mustShowPlace))) : null);

export async function saveSheet() {
  try {
    const png = await sheetPng();
    if (png) saveFile(`${fileStem() || 'view'}.png`, png);
  } catch (error) {
    reportFailure(error);
  }
}
