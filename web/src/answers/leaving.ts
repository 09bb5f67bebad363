// How many rocks leave the model: over its edge, or where its terrain has no data.

import type { NumberText } from '../api/exact';
import { percentText } from '../askLine/kit';

export function leaving(endReasons: Record<string, NumberText>, done: NumberText): { share: string; note: string } {
  const of = (reason: string) => Number(endReasons[reason] ?? 0);
  const [holes, all] = [of('no data'), Number(done)];
  const left = of('left the model') + holes;
  const text = (count: number) => count.toLocaleString('en');
  return {
    share: percentText(all > 0 ? left / all : 0),
    note: `${text(left)} of ${text(all)} rocks${holes > 0 ? `, ${text(holes)} where the terrain has no data` : ''}`,
  };
}
