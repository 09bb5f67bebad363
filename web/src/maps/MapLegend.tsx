import { readingOf, titleOf, unitOf } from '../results/columns';
import { cssOf } from '../view/colours';
import { ScaleLegend } from '../view/Legend';
import { shownMap } from './shownMap';

/// What the colours of the map on the terrain mean.
export function MapLegend() {
  const map = shownMap.value;
  if (!map) return null;
  const { unit, per } = readingOf(unitOf(map.name));
  const { colours, limits, scale, is_open_upwards } = map.header;
  const stops = colours.map(([, colour], k) => `${cssOf(colour)} ${(100 * k) / Math.max(colours.length - 1, 1)}%`);
  return (
    <ScaleLegend
      title={unit === unitOf(map.name) ? map.name : `${titleOf(map.name)}, ${unit}`}
      gradient={`linear-gradient(to right, ${stops.join(', ')})`}
      low={limits[0] / per}
      high={limits[1] / per}
      logarithmic={scale === 'log'}
      isClipped={is_open_upwards}
    />
  );
}
