// The legend of the map on the terrain.

import { numberText } from '../units/numbers';
import { cssOf } from '../view/colours';
import type { LegendData } from '../view/legends';
import { classOf, classText } from './classes';
import { shownMap, type ShownMap } from './shownMap';

function rangeText({ least, greatest, unit }: ShownMap): string {
  if (least > greatest) return 'no rocks';
  return `values from ${numberText(least, 3)} to ${numberText(greatest)} ${unit}`.trim();
}

/// Whether the range of values includes a class.
const isUsed = ({ classes, least, greatest }: ShownMap, k: number) =>
  least <= greatest && k >= classOf(classes, least) && k <= classOf(classes, greatest);

export function mapLegends(): LegendData[] {
  const map = shownMap.value;
  if (!map) return [];
  const { meaning, unit } = map;
  const classes = map.classes.map((each, k) => ({
    text: classText(each, k === 0),
    colour: cssOf(each.colour),
    isUsed: isUsed(map, k),
  }));
  const title = `${meaning.charAt(0).toUpperCase()}${meaning.slice(1)}${unit && `, ${unit}`}`;
  return [{ kind: 'classes', title, classes, note: rangeText(map) }];
}
