// Tools for the pointer in the scene and the section: drawing a line, placing a seeder, measuring. The views pass clicks
// and movements on the ground to the active tool.

import { effect, signal, untracked } from '@preact/signals';
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

export const tool = signal<Tool | null>(null);

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
}
export const overlays = signal<Record<string, Overlay[]>>({});

export function showOverlay(owner: string, list: Overlay[]) {
  // peek(): an effect that shows an overlay must not depend on it.
  const { [owner]: _, ...others } = overlays.peek();
  overlays.value = list.length > 0 ? { ...others, [owner]: list } : others;
}

/// Runs tasks of the tool in order, because a click may wait for the engine.
let turn: Promise<void> = Promise.resolve();
export function inTurn(task: () => void | Promise<void>): Promise<void> {
  return (turn = turn.then(task).catch(reportFailure));
}

function call(method: 'finish' | 'back') {
  const active = tool.value;
  void inTurn(() => {
    if (tool.value === active) active?.[method]?.();
  });
}
export const finishTool = () => call('finish');
export const removeLastPoint = () => call('back');

export function useTool(next: Tool | null) {
  tool.value?.cancel?.();
  tool.value = next;
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
