// Drawing settings in the view: which settings can be drawn, and the values written for them.

import type { Point3 } from '../api/types';
import { edit, valueAt, values } from '../project/document';
import { model } from '../project/model';
import type { Path, TableName } from '../settings/names';
import type { TomlValue } from '../toml/format';
import { setShading } from '../view/settings';
import { consequences } from '../settings/consequences';
import { draw, type Drawing } from './drawing';
import { entriesUnchanged, is2d, tableAt, thingOf } from '../project/place';
import { rounded } from '../geometry/plan';

const extent = () => {
  const bounds = model.value?.bounds;
  return bounds ? Math.max(bounds.max[0] - bounds.min[0], bounds.max[1] - bounds.min[1]) : 0;
};
const short = (value: number) => rounded(value, extent());

/// A release position on the ground: its height is "surface", or given by `height_above_m`.
function position(path: Path, [x, y]: Point3): TomlValue[] {
  const plan = is2d.value ? [short(x)] : [short(x), short(y)];
  return tableAt(path.slice(0, 2)).height_above_m !== undefined ? plan : [...plan, 'surface'];
}
export const onPlan = ([x, y]: Point3): TomlValue[] => [short(x), short(y)];
const inSection = ([x, , z]: Point3): TomlValue[] => [short(x), short(z)];

interface Drawable {
  title: string;
  start: () => void;
}

/// How a setting is drawn; null if it cannot be drawn.
export function drawable(path: Path): Drawable | null {
  const [table, key] = [path[0], path.at(-1)];
  const thing = thingOf(path);
  const drawIt = (drawing: Omit<Drawing, 'isPossible'>) => draw({ ...drawing, isPossible: entriesUnchanged(table as TableName) });
  const set = (what: string, value: TomlValue) =>
    edit(`${what} ${thing}`, [{ set: path, value }, ...consequences(values.value, path, value)]);
  if (table === 'terrain' && key === 'section' && is2d.value) {
    const old = valueAt(path);
    const hasRows = Array.isArray(old) && old.length > 0;
    return {
      title: hasRows ? 'Redraw' : 'Draw the section',
      start: () =>
        drawIt({
          name: 'Section',
          kind: 'line',
          least: 2,
          hint: 'Click the vertices of the slope, from left to right.',
          done: (places) => set('draw', places.map(inSection)),
        }),
    };
  }
  if (table === 'seeder' && key === 'position')
    return {
      title: 'Pick in the view',
      start: () =>
        drawIt({
          name: thing,
          kind: 'points',
          least: 1,
          most: 1,
          hint: 'Click where rocks start.',
          done: ([place]) => set('place', position(path, place!)),
        }),
    };
  if (table === 'seeder' && key === 'points')
    return {
      title: 'Draw in the view',
      start: () =>
        drawIt({
          name: thing,
          kind: 'line',
          least: 2,
          hint: 'Click along the line from which rocks start.',
          done: (places) =>
            set(
              'draw',
              places.map((place) => position(path, place)),
            ),
        }),
    };
  if (table === 'seeder' && key === 'polygon')
    return {
      title: 'Draw in the view',
      start: () =>
        drawIt({
          name: thing,
          kind: 'polygon',
          least: 3,
          hint: 'Click around the area from which rocks start.',
          done: (places) => set('draw', places.map(onPlan)),
        }),
    };
  if ((table === 'area' || table === 'forest') && key === 'polygon')
    return {
      title: 'Draw in the view',
      start: () => {
        setShading('material');
        drawIt({
          name: thing,
          kind: 'polygon',
          least: 3,
          hint: table === 'area' ? 'Click around the area of this material.' : 'Click around the forest.',
          done: (places) => set('draw', places.map(onPlan)),
        });
      },
    };
  if ((table === 'barrier' || table === 'collector') && key === 'line') {
    if (is2d.value)
      return {
        title: 'Pick in the view',
        start: () =>
          drawIt({
            name: thing,
            kind: 'points',
            least: 1,
            most: 1,
            hint: 'Click its position.',
            done: ([place]) => set('place', short(place![0])),
          }),
      };
    return {
      title: 'Draw in the view',
      start: () =>
        drawIt({
          name: thing,
          kind: 'line',
          least: 2,
          hint: 'Click along the line. It leans towards its right-hand side.',
          done: (places) => set('draw', places.map(onPlan)),
        }),
    };
  }
  return null;
}
