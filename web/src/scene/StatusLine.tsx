import { shownMap, valueAt } from '../maps/shownMap';
import { displayOf } from '../state/displayUnits';
import { numberText } from '../units/numbers';
import { roundStep } from '../geometry/ticks';
import { ToolHint } from '../drag/ToolHint';
import { sceneCamera } from '../view/sceneCamera';
import { contourInterval, pointer } from './picture';

/// Scale bar, contour interval, and the point under the pointer.
export function StatusLine() {
  const { metresPerPixel } = sceneCamera.value;
  const { unit, per } = displayOf('m');
  const perPixel = metresPerPixel / per;
  let length = roundStep(60 * perPixel);
  if (length / perPixel > 150) length /= 2;
  const place = pointer.value;
  const map = shownMap.value;
  const value = map && place && valueAt(map, place.point);
  return (
    <div class="status-line">
      <ToolHint />
      <span class="scale-bar" title="At the centre of the view">
        <i style={{ width: `${length / perPixel}px` }} />
        {unit === 'm' && length >= 1000 ? `${length / 1000} km` : `${numberText(length)} ${unit}`}
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
