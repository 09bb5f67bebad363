// Dragging a vertex, or all vertices of a line, in a view.

import { signal } from '@preact/signals';
import { sendJson } from '../api/client';
import type { Point3 } from '../api/types';
import { consequences } from '../settings/consequences';
import { is2d } from '../project/place';
import { rounded } from '../geometry/plan';
import { rowEdits } from '../settings/rows';
import { inTurn, overlays, showOverlay, type GripDrag, type Overlay } from '../tools/tool';
import { edit, endStep, valueAt, values } from '../project/document';
import { model } from '../project/model';
import type { TomlValue } from '../toml/format';
import { distanceToLine, type Pixel } from '../geometry/nearness';
import { roundStep } from '../geometry/ticks';
import { owned } from '../state/owned';
import { handles, snapLines, type Handles } from './handles';
import { movedRow, valueOf } from './shapes';
import { onGrid, snap, type Target } from './snapping';

/// What a view must know for dragging, in pixels of its picture.
export interface DragView {
  /// Null: not in the picture.
  pixelOf(point: Point3): Pixel | null;
  /// The ground under a pixel, or in 2D the place itself; null: no terrain.
  placeAt(pixel: Pixel): Point3 | null;
  metresPerPixel(): number;
}

export interface Keys {
  /// Ctrl: rounds to a grid.
  ctrl: boolean;
  /// Alt: neither snaps nor rounds.
  alt: boolean;
}

/// What is being dragged, in words; null if nothing is.
export const [dragHint, showDragHint] = owned(signal<string | null>(null));

const [vertexReach, lineReach] = [9, 6]; // pixels

/// What is under a pixel: a vertex of the chosen entry, or its line.
export function handleAt(view: DragView, at: Pixel): { vertex: number } | 'line' | null {
  const now = handles.peek();
  if (!now) return null;
  let [vertex, least] = [-1, vertexReach];
  now.points.forEach((point, k) => {
    const pixel = view.pixelOf(point);
    const away = pixel ? Math.hypot(pixel[0] - at[0], pixel[1] - at[1]) : Infinity;
    if (away < least) [vertex, least] = [k, away];
  });
  if (vertex >= 0) return { vertex };
  if (now.shape.kind === 'points' || now.shape.path[0] === 'terrain') return null;
  // The lines of the chosen entry lie on the ground between its vertices.
  for (const { points, kind } of overlays.peek().chosen ?? []) {
    if (kind === 'points') continue;
    const pixels = (kind === 'polygon' ? [...points, points[0]!] : points).map((point) => view.pixelOf(point));
    for (let k = 0; k + 1 < pixels.length; ++k) {
      const [a, b] = [pixels[k], pixels[k + 1]];
      if (a && b && distanceToLine(at, a, b) < lineReach) return 'line';
    }
  }
  return null;
}

/// The lines and vertices of other entries, in the picture. In 2D barriers and release places are above one another.
function targetsIn(view: DragView): Target[] {
  return snapLines.peek().flatMap(({ name, points, isLine }): Target[] => {
    const marks = points.map((point) => ({ point, pixel: view.pixelOf(point) }));
    return marks.flatMap((mark, k): Target[] => {
      if (!mark.pixel) return [];
      const own = { point: mark.point, pixel: mark.pixel };
      const next = marks[k + 1];
      const line: Target[] = isLine && next?.pixel ? [{ name, marks: [own, { point: next.point, pixel: next.pixel }] }] : [];
      return [{ name, marks: [own] }, ...line];
    });
  });
}

const coordinates = ([x, y, z]: Point3, isSection: boolean) =>
  is2d.value ? `x ${x.toFixed(2)}${isSection ? ` z ${z.toFixed(2)}` : ''} m` : `x ${x.toFixed(2)} y ${y.toFixed(2)} m`;

export class Drag {
  private readonly handles: Handles;
  private readonly targets: Target[];
  private readonly isSection: boolean;
  private readonly vertex: number | null;
  private points: Point3[];
  /// Coordinates of these vertices are those of a vertex or line that they were snapped to.
  private exact = false;

  /// Expects handles. `what` is under the pixel `from`.
  constructor(private readonly view: DragView, what: { vertex: number } | 'line', private readonly from: Pixel) {
    this.handles = handles.peek()!;
    this.points = this.handles.points;
    this.targets = targetsIn(view);
    this.isSection = this.handles.shape.path[0] === 'terrain';
    this.vertex = what === 'line' ? null : what.vertex;
  }

  private get title(): string {
    const { name, points } = this.handles;
    if (this.vertex === null || points.length === 1) return name;
    return `Vertex ${this.vertex + 1} of ${name}`;
  }

  move(to: Pixel, { ctrl, alt }: Keys) {
    const place = this.view.placeAt(to);
    if (!place) return;
    const { points: before } = this.handles;
    const step = roundStep(8 * this.view.metresPerPixel());
    let note = '';
    this.exact = false;
    if (this.vertex !== null) {
      const snapped = alt || ctrl ? null : snap(to, this.targets);
      const next = snapped ? snapped.point : ctrl && !alt ? onGrid(place, step) : place;
      this.exact = snapped !== null || (ctrl && !alt);
      this.points = before.with(this.vertex, next);
      note = `${coordinates(next, this.isSection)}${snapped ? `, on ${snapped.to}` : ''}${ctrl && !alt ? `, grid of ${step} m` : ''}`;
    } else {
      const start = this.view.placeAt(this.from);
      if (!start) return;
      const shift = place.map((value, k) => value - start[k]!) as Point3;
      const [dx, dy] = ctrl && !alt ? onGrid(shift, step) : shift;
      this.points = before.map(([x, y, z]) => [x + dx, y + dy, z]);
      note = `moved by ${dx.toFixed(2)}${is2d.value ? '' : `, ${dy.toFixed(2)}`} m`;
    }
    showDragHint(`${this.title}: ${note}`);
    this.show();
  }

  private show() {
    const { kind } = this.handles.shape;
    const line: Overlay[] = kind === 'points' ? [] : [{ points: this.points, kind: kind === 'polygon' ? 'polygon' : 'line' }];
    showOverlay('drag', [...line, { points: this.points, kind: 'points' }]);
  }

  /// Ends without a change.
  cancel() {
    showDragHint(null);
    showOverlay('drag', []);
  }

  /// Ends with the change, as one step.
  drop() {
    const { handles: before, points } = this;
    this.cancel();
    void inTurn(async () => {
      const moved = points.flatMap((point, k) => (point === before.points[k] ? [] : [k]));
      if (moved.length === 0 || handles.peek()?.shape !== before.shape) return; // changed in the meantime
      const heights = await this.heights(moved);
      const bounds = model.peek()?.bounds;
      const extent = bounds ? Math.max(bounds.max[0] - bounds.min[0], bounds.max[1] - bounds.min[1]) : 0;
      const short = (value: number) => (this.exact ? Number(value.toFixed(6)) : rounded(value, extent));
      const rows = before.shape.rows.map((row, k): TomlValue[] => {
        const place = moved.indexOf(k);
        if (place < 0) return row;
        const [x, y, z] = points[k]!;
        if (this.isSection || (is2d.value && typeof row[1] === 'number')) return [short(x), short(z), ...row.slice(2)];
        const height = heights[place];
        return movedRow(row, is2d.value ? [short(x)] : [short(x), short(y)], height === null ? null : short(height!));
      });
      const { path } = before.shape;
      const value = valueOf(before.shape, rows);
      const edits = Array.isArray(value) && Array.isArray(value[0]) ? rowEdits(path, valueAt(path), rows) : [{ set: path, value }];
      edit(`move ${this.title.replace(/^V/, 'v')}`, [...edits, ...consequences(values.value, path, value)]);
      endStep();
    });
  }

  /// The heights of moved vertices in 3D that have one: as high above the ground as before. Null: none, or no ground.
  private async heights(moved: readonly number[]): Promise<(number | null)[]> {
    const { shape, ground } = this.handles;
    const hasHeight = (k: number) => !is2d.value && typeof shape.rows[k]![2] === 'number';
    if (!moved.some(hasHeight)) return moved.map(() => null);
    const places = moved.map((k) => this.points[k]!.slice(0, 2));
    const { z } = await sendJson<{ z: (number | null)[] }>('POST', `/api/models/${model.peek()?.id}/elevations`, { points: places });
    return moved.map((k, place) => {
      const [before, now] = [ground[k] ?? null, z[place] ?? null];
      return hasHeight(k) && before !== null && now !== null ? Number(shape.rows[k]![2]) + now - before : null;
    });
  }
}

/// What follows a pointer.
type Following = Pick<Drag, 'move' | 'drop' | 'cancel'>;

/// The drag of a mark that is no entry of the project.
export const dragOf = (view: DragView, grip: GripDrag): Following => ({
  move(to, keys) {
    const point = view.placeAt(to);
    if (point) grip.move(point, keys, view.metresPerPixel());
  },
  drop: () => grip.drop(),
  cancel: () => grip.cancel(),
});

/// Follows a pointer from the moment it is pressed on a handle: moves, drops, and cancels with Escape. `ended` is
/// called at the end with whether anything was dragged.
export function followPointer(
  drag: Following,
  down: PointerEvent,
  pixelOf: (event: PointerEvent) => Pixel,
  ended: (dragged: boolean, event: PointerEvent | null) => void,
) {
  const still = 4; // pixels
  const listening = new AbortController();
  let isDragging = false;
  const end = (event: PointerEvent | null) => {
    listening.abort();
    ended(isDragging, event);
  };
  const options = { signal: listening.signal, capture: true };
  addEventListener(
    'pointermove',
    (event) => {
      if (event.pointerId !== down.pointerId) return;
      isDragging ||= Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) >= still;
      if (isDragging) drag.move(pixelOf(event), { ctrl: event.ctrlKey || event.metaKey, alt: event.altKey });
      event.stopPropagation();
    },
    options,
  );
  addEventListener(
    'pointerup',
    (event) => {
      if (event.pointerId !== down.pointerId) return;
      event.stopPropagation();
      if (isDragging) drag.drop();
      end(event);
    },
    options,
  );
  const cancel = () => {
    drag.cancel();
    end(null);
  };
  addEventListener('pointercancel', cancel, options);
  addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      cancel();
    },
    options,
  );
}
