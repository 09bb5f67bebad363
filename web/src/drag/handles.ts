// The vertices of the chosen entry as handles in the view, and what they can snap to.

import { computed, effect, signal } from '@preact/signals';
import { sendJson } from '../api/client';
import type { Point3 } from '../api/types';
import { is2d, nameOf } from '../project/place';
import type { Path, TableName } from '../settings/names';
import { showOverlay, tool } from '../tools/tool';
import { groundBelow, profile } from '../project/profile';
import { rowsOf, syntaxError, values } from '../project/document';
import { reportFailure } from '../state/messages';
import { model } from '../project/model';
import { chosen } from '../project/chosen';
import { shapeOf, type Shape } from './shapes';

export interface Handles {
  shape: Shape;
  name: string;
  /// The vertices in the view, and the ground below each; null: unknown.
  points: Point3[];
  ground: (number | null)[];
}
interface Named {
  entry: Path;
  shape: Shape;
}

const mostVertices = 2000;

const tables: readonly TableName[] = ['seeder', 'barrier', 'collector', 'area', 'forest'];
const shapes = computed<Named[]>(() => {
  if (!chosen.value || syntaxError.value) return [];
  const entries: Path[] = [['terrain'], ...tables.flatMap((table) => rowsOf(table).map((_, k): Path => [table, k]))];
  return entries.flatMap((entry) => {
    const shape = shapeOf(values.value, entry, is2d.value);
    return shape ? [{ entry, shape }] : [];
  });
});

const nameOfEntry = ([table, index]: Path) =>
  typeof index === 'number' ? nameOf(table as TableName, index) : 'the section';

/// The place of a vertex in the view, on the ground at `z` unless it has a height.
function placed(row: readonly unknown[], isSection: boolean, z: number | null): Point3 {
  const [x, second, third] = row as (number | string | undefined)[];
  if (is2d.value) return [Number(x), 0, isSection || typeof second === 'number' ? Number(second) : (z ?? 0)];
  return [Number(x), Number(second), typeof third === 'number' ? third : (z ?? 0)];
}

interface Placed extends Named {
  points: Point3[];
  ground: (number | null)[];
}
/// All shapes with their places, once the elevations are known.
const placedShapes = signal<Placed[]>([]);

const withGround = (list: readonly Named[], ground: readonly (number | null)[]): Placed[] => {
  let next = 0;
  return list.map((named) => {
    const own = named.shape.rows.map(() => ground[next++] ?? null);
    const isSection = named.entry[0] === 'terrain';
    return { ...named, ground: own, points: named.shape.rows.map((row, k) => placed(row, isSection, own[k]!)) };
  });
};

effect(() => {
  const [list, now] = [shapes.value, model.value];
  const rows = list.flatMap(({ shape }) => shape.rows);
  if (!now || list.length === 0 || rows.length > mostVertices) {
    placedShapes.value = [];
    return;
  }
  if (is2d.value) {
    const slope = profile.value;
    placedShapes.value = slope ? withGround(list, rows.map(([x]) => groundBelow(slope, Number(x))?.z ?? null)) : [];
    return;
  }
  const asking = new AbortController();
  const points = rows.map(([x, y]) => [x, y]);
  sendJson<{ z: (number | null)[] }>('POST', `/api/models/${now.id}/elevations`, { points }, asking.signal).then(
    ({ z }) => !asking.signal.aborted && (placedShapes.value = withGround(list, z)),
    reportFailure,
  );
  return () => asking.abort();
});

const isChosen = ({ entry }: Named) => chosen.value?.[0] === entry[0] && chosen.value?.[1] === entry[1];

/// The handles of the chosen entry; null if it has none, or while a tool is used.
export const handles = computed<Handles | null>(() => {
  const own = tool.value === null ? placedShapes.value.find(isChosen) : undefined;
  return own ? { shape: own.shape, name: nameOfEntry(own.entry), points: own.points, ground: own.ground } : null;
});

/// Lines and vertices to which handles can snap: those of the other entries.
export const snapLines = computed(() =>
  placedShapes.value
    .filter((other) => !isChosen(other))
    .map(({ entry, shape, points }) => ({
      name: nameOfEntry(entry),
      points: shape.kind === 'polygon' ? [...points, points[0]!] : points,
      isLine: shape.kind !== 'points',
    })),
);

/// Shows the handles in the views. Returns a function that ends this.
export const showHandles = () =>
  effect(() => {
    const now = handles.value;
    showOverlay('handles', now ? [{ points: now.points, kind: 'points' }] : []);
  });
