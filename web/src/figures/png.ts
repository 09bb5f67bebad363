// PNG files for print, with their resolution.

/// The resolution of prints and of the page [dpi].
export const printDensity = 300;
export const pageDensity = 96;
/// Pixels of a saved file per CSS pixel.
export const printRatio = printDensity / pageDensity;

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c >>> 0;
});
/// The CRC of ISO 3309 and of the PNG specification (second edition, annex D).
function crcOf(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = table[(crc ^ byte) & 0xff]! ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

const signature = 8; // bytes
const header = 25; // IHDR with its length, name and checksum

/// Adds the resolution to a PNG: a pHYs chunk after the header, in pixels per metre.
export function withDensity(png: Uint8Array, dpi: number): Uint8Array<ArrayBuffer> {
  const chunk = new Uint8Array(4 + 4 + 9 + 4);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, 9);
  chunk.set([...'pHYs'].map((letter) => letter.charCodeAt(0)), 4);
  const pixelsPerMetre = Math.round(dpi / 0.0254);
  view.setUint32(8, pixelsPerMetre);
  view.setUint32(12, pixelsPerMetre);
  chunk[16] = 1; // the unit is the metre
  view.setUint32(17, crcOf(chunk.subarray(4, 17)));
  const before = signature + header;
  const whole = new Uint8Array(png.length + chunk.length);
  whole.set(png.subarray(0, before));
  whole.set(chunk, before);
  whole.set(png.subarray(before), before + chunk.length);
  return whole;
}

export async function printPng(canvas: HTMLCanvasElement): Promise<Blob> {
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new Error('The picture could not be created.');
  return new Blob([withDensity(new Uint8Array(await blob.arrayBuffer()), printDensity)], { type: 'image/png' });
}
