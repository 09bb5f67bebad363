// A map of results as a picture; where no rock was it is clear.

import { DataTexture, LinearFilter, NearestFilter, RGBAFormat } from 'three';
import { colourOfValue, type ShownMap } from '../maps/shownMap';

export function mapTexture(map: ShownMap): DataTexture {
  const { columns, rows } = map.header;
  const bytes = new Uint8Array(4 * columns * rows);
  map.values.forEach((value, k) => {
    if (!Number.isNaN(value)) bytes.set([...colourOfValue(map.header, value), 255], 4 * k);
  });
  const made = new DataTexture(bytes, columns, rows, RGBAFormat);
  made.magFilter = NearestFilter; // a cell is a cell
  made.minFilter = LinearFilter;
  made.userData.of = map;
  made.needsUpdate = true;
  return made;
}
