// A drawing of the page as a file of its own.

import { sayFailure } from '../state/messages';
import { saveFile } from './save';

const space = 'http://www.w3.org/2000/svg';

function textOf(drawing: SVGSVGElement, ground: string): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const { width, height } = drawing.getBoundingClientRect();
  copy.setAttribute('xmlns', space);
  copy.setAttribute('width', String(width));
  copy.setAttribute('height', String(height));
  copy.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const sheet = document.createElementNS(space, 'rect');
  sheet.setAttribute('width', '100%');
  sheet.setAttribute('height', '100%');
  sheet.setAttribute('fill', ground);
  copy.prepend(sheet);
  return new XMLSerializer().serializeToString(copy);
}

export function saveSvg(name: string, drawing: SVGSVGElement | null, ground: string) {
  if (drawing) saveFile(name, new Blob([textOf(drawing, ground)], { type: 'image/svg+xml' }));
}

const pixelsAPoint = 2; // sharp on paper

export function savePng(name: string, drawing: SVGSVGElement | null, ground: string) {
  if (drawing) paint(drawing, ground).then((content) => saveFile(name, content), sayFailure);
}

async function paint(drawing: SVGSVGElement, ground: string): Promise<Blob> {
  const { width, height } = drawing.getBoundingClientRect();
  const address = URL.createObjectURL(new Blob([textOf(drawing, ground)], { type: 'image/svg+xml' }));
  try {
    const picture = new Image(width, height);
    picture.src = address;
    await picture.decode();
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(width * pixelsAPoint);
    canvas.height = Math.round(height * pixelsAPoint);
    canvas.getContext('2d')!.drawImage(picture, 0, 0, canvas.width, canvas.height);
    return await new Promise((done, fail) =>
      canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error('The picture could not be made.'))), 'image/png'),
    );
  } finally {
    URL.revokeObjectURL(address);
  }
}
