// What the view shows, as text for the page's address: the name of a named view, or numbers in the project's
// coordinates [m]. 3D: the eye and the point it looks at (six); 2D: the centre, the width and the height (four).

import { ofProject } from '../project/ofProject';
import { owned } from '../state/owned';

/// What the view shows now; null: all of the model, as when it is opened.
export const [camera, tellCamera] = owned(ofProject<string | null>(null));
/// What the view is asked to show, until it does.
export const [wantedCamera, wantCamera] = owned(ofProject<string | null>(null));

export const cameraText = (numbers: readonly number[]) => numbers.map((number) => String(Number(number.toFixed(2)))).join(',');

/// The numbers of a text; null if they are not `count` finite numbers.
export function cameraNumbers(text: string, count: number): number[] | null {
  const numbers = text.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}
