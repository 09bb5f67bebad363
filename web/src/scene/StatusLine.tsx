import { shownMap, valueAt } from '../maps/shownMap';
import { numberText } from '../ui/format';
import { roundStep } from '../view/ticks';
import { ToolHint } from './ToolHint';
import { camera, contourInterval, pointer } from './picture';

/// Scale bar, contour interval, and the point under the pointer.
export function StatusLine() {
  const { metresPerPixel } = camera.value;
  let metres = roundStep(60 * metresPerPixel);
  if (metres / metresPerPixel > 150) metres /= 2;
  const place = pointer.value;
  const map = shownMap.value;
  const value = map && place && valueAt(map, place.point);
  return (
    <div class="status-line">
      <ToolHint />
      <span class="scale-bar" title="At the centre of the view">
        <i style={{ width: `${metres / metresPerPixel}px` }} />
        {metres >= 1000 ? `${metres / 1000} km` : `${numberText(metres)} m`}
      </span>
      {contourInterval.value > 0 && <span>contour interval {numberText(contourInterval.value)} m</span>}
      {place && map && (
        <span class="map-value">
          {map.meaning}: {value === null ? 'no rock' : <strong>{`${numberText(value!)} ${map.unit}`}</strong>}
        </span>
      )}
      {place && (
        <span class="mono">
          x {place.point[0].toFixed(2)} y {place.point[1].toFixed(2)} z {place.isCoarse && '≈ '}
          {place.point[2].toFixed(2)} m
        </span>
      )}
    </div>
  );
}
