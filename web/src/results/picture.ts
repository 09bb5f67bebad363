// A drawing of the page as a file of its own.

import { sayFailure } from '../state/messages';
import { printPng, printRatio } from '../view/png';
import { saveFile } from './save';

const space = 'http://www.w3.org/2000/svg';

/// What stands over a drawing in its file, where nothing of the page is around it.
export interface Heading {
  title: string;
  /// Colours of the page.
  ground: string;
  text: string;
}

const headHeight = 30; // pixels

const sizeOf = (drawing: SVGSVGElement) => {
  const { width, height } = drawing.getBoundingClientRect();
  return { width, height: height + headHeight };
};

function textOf(drawing: SVGSVGElement, { title, ground, text }: Heading): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const { width, height } = sizeOf(drawing);
  copy.setAttribute('xmlns', space);
  copy.setAttribute('width', String(width));
  copy.setAttribute('height', String(height));
  copy.setAttribute('viewBox', `0 ${-headHeight} ${width} ${height}`);
  const sheet = document.createElementNS(space, 'rect');
  for (const [name, value] of Object.entries({ y: -headHeight, width, height, fill: ground })) sheet.setAttribute(name, String(value));
  const head = document.createElementNS(space, 'text');
  const place = { x: 12, y: -10, fill: text, 'font-size': 14, 'font-weight': 600, 'font-family': 'system-ui, sans-serif' };
  for (const [name, value] of Object.entries(place)) head.setAttribute(name, String(value));
  head.textContent = title;
  copy.prepend(sheet, head);
  return new XMLSerializer().serializeToString(copy);
}

export function saveSvg(name: string, drawing: SVGSVGElement | null, heading: Heading) {
  if (drawing) saveFile(name, new Blob([textOf(drawing, heading)], { type: 'image/svg+xml' }));
}

export function savePng(name: string, drawing: SVGSVGElement | null, heading: Heading) {
  if (drawing) paint(drawing, heading).then((content) => saveFile(name, content), sayFailure);
}

async function paint(drawing: SVGSVGElement, heading: Heading): Promise<Blob> {
  const { width, height } = sizeOf(drawing);
  const address = URL.createObjectURL(new Blob([textOf(drawing, heading)], { type: 'image/svg+xml' }));
  try {
    const picture = new Image(width, height);
    picture.src = address;
    await picture.decode();
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(width * printRatio);
    canvas.height = Math.round(height * printRatio);
    canvas.getContext('2d', { alpha: false, willReadFrequently: true })!.drawImage(picture, 0, 0, canvas.width, canvas.height);
    return await printPng(canvas);
  } finally {
    URL.revokeObjectURL(address);
  }
}
