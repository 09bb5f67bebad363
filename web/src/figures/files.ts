// Saves figures and tables as files.

import { printPng, printRatio } from './png';

export type Cell = string | number;

export function saveFile(name: string, content: Blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/// RFC 4180.
export function csvText(rows: readonly (readonly (Cell | null | undefined)[])[]): string {
  const cell = (value: Cell | null | undefined) => {
    const text = String(value ?? '');
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return rows.map((row) => `${row.map(cell).join(',')}\r\n`).join('');
}

export const saveCsv = (name: string, rows: readonly (readonly (Cell | null | undefined)[])[]) =>
  saveFile(`${name}.csv`, new Blob([csvText(rows)], { type: 'text/csv' }));

const headHeight = 30; // the drawing's units

const sizeOf = (svg: SVGSVGElement) => {
  const { width, height } = svg.viewBox.baseVal;
  return { width, height: height + headHeight };
};

const kept = [
  'display',
  'fill',
  'fill-opacity',
  'font-family',
  'font-size',
  'font-weight',
  'opacity',
  'paint-order',
  'stroke',
  'stroke-dasharray',
  'stroke-linecap',
  'stroke-linejoin',
  'stroke-opacity',
  'stroke-width',
  'text-anchor',
];

/// A standalone SVG with its title above. The page's style is written into every element, so that it looks the same
/// everywhere.
export function drawingText(svg: SVGSVGElement, title: string): string {
  const space = 'http://www.w3.org/2000/svg';
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const from = [svg, ...svg.querySelectorAll<SVGElement>('*')];
  const to = [copy, ...copy.querySelectorAll<SVGElement>('*')];
  from.forEach((source, k) => {
    const style = getComputedStyle(source);
    for (const property of kept) to[k]!.style.setProperty(property, style.getPropertyValue(property));
  });
  const { width, height } = sizeOf(svg);
  const page = getComputedStyle(svg);
  const sheet = document.createElementNS(space, 'rect');
  const head = document.createElementNS(space, 'text');
  const set = (node: Element, values: Record<string, string | number>) =>
    Object.entries(values).forEach(([name, value]) => node.setAttribute(name, String(value)));
  set(copy, { xmlns: space, width, height, viewBox: `0 ${-headHeight} ${width} ${height}` });
  set(sheet, { y: -headHeight, width, height, fill: page.getPropertyValue('--page').trim() || '#ffffff' });
  set(head, {
    x: 12,
    y: -10,
    fill: page.getPropertyValue('--ink').trim() || '#000000',
    'font-size': 14,
    'font-weight': 600,
  });
  head.setAttribute('font-family', 'system-ui, sans-serif');
  head.textContent = title;
  copy.prepend(sheet, head);
  return new XMLSerializer().serializeToString(copy);
}

const svgBlob = (svg: SVGSVGElement, title: string) => new Blob([drawingText(svg, title)], { type: 'image/svg+xml' });

export const saveSvg = (name: string, svg: SVGSVGElement, title: string) =>
  saveFile(`${name}.svg`, svgBlob(svg, title));

/// For print, at 300 dpi.
export async function savePng(name: string, svg: SVGSVGElement, title: string): Promise<void> {
  const { width, height } = sizeOf(svg);
  const address = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(drawingText(svg, title))}`;
  const picture = new Image(width, height);
  picture.src = address;
  await picture.decode();
  const canvas = document.createElement('canvas');
  canvas.width = Math.round(width * printRatio);
  canvas.height = Math.round(height * printRatio);
  canvas
    .getContext('2d', { alpha: false, willReadFrequently: true })!
    .drawImage(picture, 0, 0, canvas.width, canvas.height);
  saveFile(`${name}.png`, await printPng(canvas));
}
