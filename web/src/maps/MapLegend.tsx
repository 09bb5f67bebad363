import { cssOf } from '../view/colours';
import { ClassesLegend } from '../view/Legend';
import { numberText } from '../ui/format';
import { classOf, classText } from './classes';
import { shownMap, type ShownMap } from './shownMap';

export const mapTitle = ({ meaning, unit }: ShownMap) =>
  `${meaning.charAt(0).toUpperCase()}${meaning.slice(1)}${unit && `, ${unit}`}`;

export function mapRange({ least, greatest, unit }: ShownMap): string {
  return least > greatest ? 'no rock anywhere' : `values from ${numberText(least, 3)} to ${numberText(greatest)} ${unit}`.trim();
}

/// Whether any value that is shown can be of a class.
export const isThere = ({ classes, least, greatest }: ShownMap, k: number) =>
  least <= greatest && k >= classOf(classes, least) && k <= classOf(classes, greatest);

/// What the colours of the map on the terrain mean.
export function MapLegend() {
  const map = shownMap.value;
  if (!map) return null;
  return (
    <ClassesLegend
      title={mapTitle(map)}
      classes={map.classes.map((each, k) => ({
        text: classText(each, k === 0),
        colour: cssOf(each.colour),
        isThere: isThere(map, k),
      }))}
      note={mapRange(map)}
    />
  );
}
