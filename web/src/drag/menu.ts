// The context menu of the views: what can be done with what is under the pointer.

import { signal } from '@preact/signals';
import type { Point3 } from '../api/types';
import { consequences } from '../settings/consequences';
import { drawable, onPlan } from '../tools/geometryTools';
import type { Path, TableName } from '../settings/names';
import { is2d, nameOf } from '../project/place';
import { rounded } from '../geometry/plan';
import { rowEdits } from '../settings/rows';
import { add, copy, remove } from '../project/things';
import { edit, rowsOf, valueAt, values } from '../project/document';
import { notify } from '../state/messages';
import { model } from '../project/model';
import { chosen, openForm } from '../project/chosen';
import { showRock } from '../runs/chosenRock';
import type { TomlValue } from '../toml/format';
import { distanceToLine, type Pixel } from '../geometry/nearness';
import { handleAt, type DragView } from './drag';
import { handles } from './handles';
import { thingAt } from './things';
import { owned } from '../state/owned';

export interface MenuItem {
  title: string;
  act: () => void;
  isDanger?: boolean;
}
export interface Menu {
  title: string;
  /// In the window [CSS pixels].
  x: number;
  y: number;
  items: MenuItem[];
}
export const [menu, setMenu] = owned(signal<Menu | null>(null));

const extent = () => {
  const bounds = model.peek()?.bounds;
  return bounds ? Math.max(bounds.max[0] - bounds.min[0], bounds.max[1] - bounds.min[1]) : 0;
};
const short = (value: number) => rounded(value, extent());
const inView = ([x, y, z]: Point3): string => (is2d.peek() ? `${short(x)}, ${short(z)}` : `${short(x)}, ${short(y)}, ${short(z)}`);

function setRows(what: string, rows: TomlValue[][]) {
  const { path } = handles.peek()!.shape;
  edit(what, [...rowEdits(path, valueAt(path), rows), ...consequences(values.value, path, rows)]);
}

/// The line between two vertices of the chosen entry that is nearest to a pixel: the number of its first vertex.
function nearestLine(view: DragView, at: Pixel): number | null {
  const { points, shape } = handles.peek()!;
  const ring = shape.kind === 'polygon' ? [...points, points[0]!] : points;
  let [found, least]: [number | null, number] = [null, Infinity];
  for (let k = 0; k + 1 < ring.length; ++k) {
    const [a, b] = [view.pixelOf(ring[k]!), view.pixelOf(ring[k + 1]!)];
    const away = a && b ? distanceToLine(at, a, b) : Infinity;
    if (away < least) [found, least] = [k, away];
  }
  return found;
}

function ofVertex(vertex: number): MenuItem[] {
  const { shape, name } = handles.peek()!;
  if (shape.rows.length <= shape.least) return [];
  return [
    {
      title: `Delete vertex ${vertex + 1}`,
      isDanger: true,
      act: () => setRows(`delete vertex ${vertex + 1} of ${name}`, shape.rows.filter((_, k) => k !== vertex)),
    },
  ];
}

/// Inserting a vertex into a line of the chosen entry.
function ofLine(view: DragView, at: Pixel, place: Point3 | null): MenuItem[] {
  const now = handles.peek();
  if (!now || !place || now.shape.kind === 'points') return [];
  const after = nearestLine(view, at);
  if (after === null) return [];
  const { shape, name } = now;
  const isSection = shape.path[0] === 'terrain';
  const like = shape.rows[after]!;
  const row: TomlValue[] = isSection
    ? [short(place[0]), short(place[2])]
    : [...onPlan(place), ...like.slice(2).map((cell) => (typeof cell === 'number' ? short(place[2]) : cell))];
  return [
    {
      title: 'Insert a vertex here',
      act: () => setRows(`insert a vertex into ${name}`, shape.rows.toSpliced(after + 1, 0, row)),
    },
  ];
}

function ofThing(path: Path): MenuItem[] {
  const [table, index] = path as [TableName, number];
  const name = nameOf(table, index);
  return [
    ...(chosen.peek()?.join('.') === path.join('.') ? [] : [{ title: `Open ${name}`, act: () => openForm(path) }]),
    { title: `Copy ${name}`, act: () => copy(table, index) },
    { title: `Delete ${name}`, act: () => remove(table, index), isDanger: true },
  ];
}

/// Adds a barrier at a place, or begins to draw it.
function addBarrier([x]: Point3) {
  if (is2d.peek()) return add('barrier', { line: short(x) });
  add('barrier');
  drawable(['barrier', rowsOf('barrier').length - 1, 'line'])?.start();
}

function ofPlace(place: Point3): MenuItem[] {
  const [x, y] = place;
  return [
    { title: 'Add a seeder here', act: () => add('seeder', { position: is2d.peek() ? [short(x), 'surface'] : [short(x), short(y), 'surface'] }) },
    { title: is2d.peek() ? 'Add a barrier here' : 'Draw a barrier', act: () => addBarrier(place) },
    {
      title: 'Copy the coordinates',
      act: () => void navigator.clipboard.writeText(inView(place)).then(() => notify('note', `Copied ${inView(place)}`), () => notify('note', inView(place))),
    },
  ];
}

/// Opens the menu of a pixel of a view, at a place of the window. `rock`: of the trajectory there. `more`: of the view.
export function openMenu(view: DragView, at: Pixel, window: { x: number; y: number }, rock: number | null, more: (place: Point3) => MenuItem[] = () => []) {
  const place = view.placeAt(at);
  const handle = handleAt(view, at);
  const thing = thingAt(view, at);
  const own = handles.peek();
  const isOnSection = own?.shape.path[0] === 'terrain' && nearLineOf(view, at);
  const items: MenuItem[] = [
    ...(handle && handle !== 'line' ? ofVertex(handle.vertex) : handle === 'line' || isOnSection ? ofLine(view, at, place) : []),
    ...(thing ? ofThing(thing) : []),
    ...(rock !== null
      ? [{ title: `Show rock ${rock}`, act: () => showRock(rock) }]
      : []),
    ...(place ? [...ofPlace(place), ...more(place)] : []),
  ];
  const title = thing ? nameOf(thing[0] as TableName, thing[1] as number) : rock !== null ? `Rock ${rock}` : place ? inView(place) : 'View';
  setMenu(items.length > 0 ? { title, ...window, items } : null);
}

const reach = 8; // pixels
function nearLineOf(view: DragView, at: Pixel): boolean {
  const { points } = handles.peek()!;
  return points.some((point, k) => {
    const [a, b] = [view.pixelOf(point), points[k + 1] ? view.pixelOf(points[k + 1]!) : null];
    return a !== null && b !== null && distanceToLine(at, a, b) < reach;
  });
}
