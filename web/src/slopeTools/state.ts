// The open slope tool and its numbers, which are no part of the project until they are applied.

import { batch, computed, effect } from '@preact/signals';
import { is2d } from '../project/place';
import { edit, endStep, syntaxError, values } from '../project/document';
import { ofProject } from '../project/ofProject';
import { isAsking, openCard } from '../askLine/asked';
import { slopeEdits } from './edits';
import { Impossible, slopeIn, type Slope } from './slope';
import { fallsLeft, shaped, stationAt, usualNumbers, type Numbers, type Shaped, type ToolKind } from './tools';

export type Pane = ToolKind | 'stays';
/// Null: the card is closed.
export const slopePane = ofProject<Pane | null>(null);
/// The last numbers of each tool.
const given = ofProject<Partial<Record<ToolKind, Numbers>>>({});
/// The toe and the far edge of which a run is asked; null: those of a usual ditch.
const askedStretch = ofProject<[number, number] | null>(null);

export function openPane(pane: Pane | null) {
  batch(() => {
    if (pane !== null) openCard(false);
    slopePane.value = pane;
  });
}
// There is room for one card.
effect(() => {
  if (isAsking.value) slopePane.value = null;
});

type Found<T> = { value: T } | { problem: string };
function tried<T>(make: () => T): Found<T> {
  try {
    return { value: make() };
  } catch (error) {
    if (error instanceof Impossible) return { problem: error.message };
    throw error;
  }
}

interface Ground {
  slope: Slope;
  isListedLeftwards: boolean;
  isLeft: boolean;
}
const ground = computed<Found<Ground>>(() =>
  tried(() => {
    if (slopePane.value === null || !is2d.value) throw new Impossible('Slope tools are for sections in 2D.');
    if (syntaxError.value) throw new Impossible('The text is not valid TOML. Correct it in the Text tab first.');
    const found = slopeIn(values.value);
    return { ...found, isLeft: fallsLeft(found.slope) };
  }),
);

/// The open tool; null: none.
export const kind = computed<ToolKind | null>(() => (slopePane.value === 'stays' ? null : slopePane.value));
export const numbers = computed<Numbers>(() => {
  if (!kind.value) return {};
  const own = given.value[kind.value];
  if (own) return own;
  return 'value' in ground.value ? usualNumbers(kind.value, ground.value.value.slope, ground.value.value.isLeft) : {};
});
export function setNumbers(next: Numbers) {
  if (kind.peek()) given.value = { ...given.peek(), [kind.peek()!]: next };
}

/// Puts the outer edge of a bench at an elevation; NaN if the section has no ground there.
export function setElevation(z: number) {
  const now = ground.peek();
  if ('problem' in now) return;
  const found = tried(() => stationAt(now.value.slope, z, now.value.isLeft));
  setNumbers({ ...numbers.peek(), x: 'value' in found ? found.value : NaN });
}

/// The slope with the open tool.
export const preview = computed<Found<Shaped> | null>(() => {
  const now = ground.value;
  if (!kind.value) return null;
  if ('problem' in now) return now;
  const tool = kind.value;
  return tried(() => shaped(tool, numbers.value, now.value.slope, now.value.isLeft));
});
/// The last possible one of this tool, whose handles stay while a drag goes through numbers that are impossible.
let last: { kind: ToolKind | null; shaped: Shaped | null } = { kind: null, shaped: null };
export const possible = computed<Shaped | null>(() => {
  if (last.kind !== kind.value) last = { kind: kind.value, shaped: null };
  if (preview.value && 'value' in preview.value) last.shaped = preview.value.value;
  return last.shaped;
});

export const problem = computed(() => {
  const now = preview.value ?? ground.value;
  return 'problem' in now ? now.problem : null;
});

export const vertices = () => {
  const now = ground.peek();
  return 'value' in now ? now.value.slope.vertices : [];
};

/// The edits of the open tool.
export function editsNow() {
  const [now, made] = [ground.peek(), preview.peek()];
  return 'value' in now && made && 'value' in made ? slopeEdits(values.peek(), made.value.slope, now.value.isListedLeftwards) : null;
}

const verbs: Record<ToolKind, string> = { bench: 'cut a bench', ditch: 'dig a ditch', berm: 'raise a berm', regrade: 'regrade the slope' };

/// Puts the open tool's shape into the project, as one step of Undo, and shows what stays in it.
export function apply() {
  const [tool, made, edits] = [kind.peek(), preview.peek(), editsNow()];
  if (!tool || !made || !('value' in made) || !edits) return;
  endStep();
  if (!edit(verbs[tool], edits)) return;
  endStep();
  batch(() => {
    const { [tool]: _, ...others } = given.peek();
    given.value = others;
    askedStretch.value = made.value.keeps;
    slopePane.value = 'stays';
  });
}

/// Between 'toe' and 'far edge', in the direction in which rocks fall.
export const stretch = computed<[number, number]>(() => {
  if (askedStretch.value) return askedStretch.value;
  const now = ground.value;
  if ('problem' in now) return [0, 0];
  const usual = tried(() => shaped('ditch', usualNumbers('ditch', now.value.slope, now.value.isLeft), now.value.slope, now.value.isLeft).keeps);
  return 'value' in usual ? usual.value : [now.value.slope.vertices[0]![0], now.value.slope.vertices.at(-1)![0]];
});
export const setStretch = (next: [number, number]) => (askedStretch.value = next);
