// The coarse relief of a terrain: its heights, and its picture.

import type { Relief } from '../archive/summary';
import { isNumber } from './format';

// The height at a place between grid points; null outside and at holes.
function reliefHeight({ x0, y0, cell_m, columns, rows, z_m }: Relief, x: number, y: number): number | null {
  const [i, j] = [(x - x0) / cell_m, (y - y0) / cell_m];
  const [i0, j0] = [Math.min(Math.floor(i), columns - 2), Math.min(Math.floor(j), rows - 2)];
  if (i < -1e-6 || j < -1e-6 || i > columns - 1 + 1e-6 || j > rows - 1 + 1e-6 || i0 < 0 || j0 < 0) return null;
  const at = (a: number, b: number) => z_m[b * columns + a];
  const [southWest, southEast, northWest, northEast] = [at(i0, j0), at(i0 + 1, j0), at(i0, j0 + 1), at(i0 + 1, j0 + 1)];
  if (!isNumber(southWest) || !isNumber(southEast) || !isNumber(northWest) || !isNumber(northEast)) return null;
  const [s, t] = [i - i0, j - j0];
  return (southWest * (1 - s) + southEast * s) * (1 - t) + (northWest * (1 - s) + northEast * s) * t;
}

/// The height at places, also at those of the outer half cells, where it is that of the next grid point.
export const groundIn = (relief: Relief) => (x: number, y: number): number | null => {
  const { x0, y0, cell_m, columns, rows } = relief;
  const within = (value: number, first: number, count: number) => {
    const last = first + (count - 1) * cell_m;
    const nearest = Math.min(Math.max(value, first), last);
    return Math.abs(value - nearest) <= 0.51 * cell_m ? nearest : value;
  };
  return reliefHeight(relief, within(x, x0, columns), within(y, y0, rows));
};

/// Red, green, blue and opacity up to 255.
type Pixel = [number, number, number, number];

function canvasOf(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  return [canvas, canvas.getContext('2d')!];
}

/// A picture of a grid, one pixel per cell; `pixelAt` counts from the south-west, null: transparent.
export function gridPicture(columns: number, rows: number, pixelAt: (column: number, row: number) => Pixel | null): HTMLCanvasElement {
  const [canvas, context] = canvasOf(columns, rows);
  const image = context.createImageData(columns, rows);
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const pixel = pixelAt(column, row);
      if (pixel) image.data.set(pixel, 4 * ((rows - 1 - row) * columns + column));
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

// How light ground of these slopes is, from 0 to 1, lit from the north-west at 45 degrees.
function lightOf(sx: number, sy: number): number {
  const lit = (sx * 0.5 - sy * 0.5 + Math.SQRT1_2) / Math.hypot(sx, sy, 1);
  return Math.min(Math.max(lit, 0), 1);
}

/// Shaded relief as the address of a picture, with one pixel per grid point, enlarged with smoothing because printers
/// draw pixels as squares.
export function hillshade({ columns, rows, cell_m, z_m }: Relief): string {
  const at = (i: number, j: number) => z_m[Math.min(Math.max(j, 0), rows - 1) * columns + Math.min(Math.max(i, 0), columns - 1)];
  const picture = gridPicture(columns, rows, (i, j) => {
    const z = at(i, j);
    if (!isNumber(z)) return null;
    const near = (a: number, b: number) => at(a, b) ?? z;
    const sx = (near(i + 1, j) - near(i - 1, j)) / (2 * cell_m);
    const sy = (near(i, j + 1) - near(i, j - 1)) / (2 * cell_m);
    const grey = Math.round(150 + 100 * lightOf(sx, sy));
    return [grey, grey, Math.max(grey - 6, 0), 255];
  });
  const times = Math.max(1, Math.ceil(800 / Math.max(columns, rows)));
  const [large, pen] = canvasOf(columns * times, rows * times);
  pen.imageSmoothingQuality = 'high';
  pen.drawImage(picture, 0, 0, large.width, large.height);
  return large.toDataURL('image/png');
}
