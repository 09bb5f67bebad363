// A map of results as a texture, transparent where no rock passed.

import { DataTexture, NearestFilter, RGBAFormat } from 'three';
import { classOf } from '../maps/classes';
import type { ShownMap } from '../maps/shownMap';

export function mapTexture(map: ShownMap): DataTexture {
  const { columns, rows } = map.header;
  const bytes = new Uint8Array(4 * columns * rows);
  map.values.forEach((value, k) => {
    if (!Number.isNaN(value)) bytes.set([...map.classes[classOf(map.classes, value)]!.colour, 255], 4 * k);
  });
  const made = new DataTexture(bytes, columns, rows, RGBAFormat);
  made.magFilter = made.minFilter = NearestFilter; // no interpolation between classes
  made.userData.of = map;
  made.needsUpdate = true;
  return made;
}
