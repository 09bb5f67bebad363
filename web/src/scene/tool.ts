// What the pointer does in the scene or on the section when it does not move the view: draw a line, place a seeder,
// measure. Who wants to draw makes a tool active; the views tell it where the pointer is on the ground.

import { effect, signal, untracked } from '@preact/signals';
import type { Point3 } from '../api/types';
import { opening } from '../state/document';
import { sayFailure } from '../state/messages';

/// A place on the terrain, in the project's coordinates. In 2D, y is 0.
export interface Place {
  point: Point3;
  /// The triangle of a mesh or the segment of a section that was hit.
  facet?: number;
  /// The terrain is drawn coarser here than it is: the height is about right.
  isCoarse?: boolean;
}

export interface Tool {
  name: string;
  /// What to do now, shown above the view.
  hint: () => string;
  click(place: Place, keys: { shift: boolean; ctrl: boolean }): void;
  move?(place: Place | null): void;
  /// Enter or a double click.
  finish?(): void;
  /// Escape; the tool is left afterwards.
  cancel?(): void;
  /// Backspace: the last point goes.
  back?(): void;
  /// Whether what the tool is for is still there; it is left when not.
  isPossible?(): boolean;
}

export const tool = signal<Tool | null>(null);

/// What tools and forms show in the scene besides the model.
export interface Overlay {
  points: Point3[];
  kind: 'line' | 'points' | 'polygon';
  colour?: string;
  label?: string;
  /// A line without marks of its points.
  isBare?: boolean;
}
export const overlays = signal<Record<string, Overlay[]>>({});

export function showOverlay(owner: string, list: Overlay[]) {
  // Not read as a dependency: effects that show something would follow themselves.
  const { [owner]: _, ...others } = overlays.peek();
  overlays.value = list.length > 0 ? { ...others, [owner]: list } : others;
}

/// A click may wait for the engine. What is asked of the tool after it waits with it.
let turn: Promise<void> = Promise.resolve();
export function inTurn(task: () => void | Promise<void>): Promise<void> {
  return (turn = turn.then(task).catch(sayFailure));
}

function ask(what: 'finish' | 'back') {
  const asked = tool.value;
  void inTurn(() => {
    if (tool.value === asked) asked?.[what]?.();
  });
}
export const finishTool = () => ask('finish');
export const takeBack = () => ask('back');

export function useTool(next: Tool | null) {
  tool.value?.cancel?.();
  tool.value = next;
}

const leaveTool = () => untracked(() => useTool(null));
effect(() => {
  if (tool.value?.isPossible?.() === false) leaveTool();
});
effect(() => {
  void opening.value;
  leaveTool();
});
