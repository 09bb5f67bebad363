// Tools for the pointer in the scene and the section: drawing a line, placing a seeder, measuring. The views pass clicks
// and movements on the ground to the active tool.

import { effect, signal, untracked, type ReadonlySignal } from '@preact/signals';
import type { Point3 } from '../api/types';
import { opening } from '../project/document';
import { reportFailure } from '../state/messages';
import type { Pixel } from '../geometry/nearness';

/// A point on the terrain in the project's coordinates. In 2D, y is 0.
export interface Place {
  point: Point3;
  /// The triangle of a mesh or the segment of a section that was hit.
  facet?: number;
  /// The terrain is drawn at lower resolution here, so the height is approximate.
  isCoarse?: boolean;
}

export interface Tool {
  name: string;
  /// The current instruction.
  hint: () => string;
  click(place: Place, keys: { shift: boolean; ctrl: boolean }): void;
  move?(place: Place | null): void;
  /// Enter or a double click.
  finish?(): void;
  /// Escape; the tool is closed afterwards.
  cancel?(): void;
  /// Backspace removes the last point.
  back?(): void;
  /// Whether the edited entry still exists; otherwise the tool is closed.
  isPossible?(): boolean;
}

const active = signal<Tool | null>(null);
export const tool: ReadonlySignal<Tool | null> = active;

/// Marks that tools and forms show in the views.
export interface Overlay {
  points: Point3[];
  kind: 'line' | 'points' | 'polygon';
  colour?: string;
  label?: string;
  /// A line without marks at its points.
  isBare?: boolean;
  isDashed?: boolean;
  /// Of a line [pixels].
  width?: number;
  /// A place that must not be overlooked: with a halo, and named on a plate. `isFitted`: a view that was not moved shows it.
  place?: { name: string; isFitted: boolean };
}
const shown = signal<Record<string, Overlay[]>>({});
export const overlays: ReadonlySignal<Record<string, Overlay[]>> = shown;

export function showOverlay(owner: string, list: Overlay[]) {
  // peek(): an effect that shows an overlay must not depend on it.
  const { [owner]: _, ...others } = shown.peek();
  shown.value = list.length > 0 ? { ...others, [owner]: list } : others;
}

/// Runs tasks of the tool in order, because a click may wait for the engine.
let turn: Promise<void> = Promise.resolve();
export function inTurn(task: () => void | Promise<void>): Promise<void> {
  return (turn = turn.then(task).catch(reportFailure));
}

function call(method: 'finish' | 'back') {
  const then = tool.value;
  void inTurn(() => {
    if (tool.value === then) then?.[method]?.();
  });
}
export const finishTool = () => call('finish');
export const removeLastPoint = () => call('back');

export function useTool(next: Tool | null) {
  tool.value?.cancel?.();
  active.value = next;
}
/// Ends a tool that has done its work, without cancelling it.
export function leaveTool(name: string) {
  if (active.value?.name === name) active.value = null;
}

const closeTool = () => untracked(() => useTool(null));
effect(() => {
  if (tool.value?.isPossible?.() === false) closeTool();
});
effect(() => {
  void opening.value;
  closeTool();
});

/// The drag of a mark in a view.
export interface GripDrag {
  /// To a place on the ground, or in the section.
  move(to: Point3, keys: { ctrl: boolean; alt: boolean }, metresPerPixel: number): void;
  drop(): void;
  cancel(): void;
}
/// Returns the drag that would begin at a pixel; null if it has nothing to drag there. `pixelOf` returns the pixel of a
/// point of the project; null outside the view.
export type Grip = (pixelOf: (point: Point3) => Pixel | null, at: Pixel) => GripDrag | null;
/// Marks beside the project that can be dragged while no tool is active.
export const grips = new Set<Grip>();

export function gripAt(pixelOf: (point: Point3) => Pixel | null, at: Pixel): GripDrag | null {
  if (tool.peek()) return null;
  for (const grip of grips) {
    const found = grip(pixelOf, at);
    if (found) return found;
  }
  return null;
}
