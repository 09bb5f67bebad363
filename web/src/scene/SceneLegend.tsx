// What the colours of the ground mean.

import { model } from '../state/model';
import { MapLegend } from '../maps/MapLegend';
import { shownMap } from '../maps/shownMap';
import { PathLegend } from '../paths/PathLegend';
import { cssGradient, elevationRamp, materialColour, slopeRamp } from '../view/colours';
import { KindsLegend, ScaleLegend } from '../view/Legend';
import { layers, shading } from '../view/settings';
import { shade } from '../view/theme';
import { elevations } from './picture';

function GroundLegend() {
  const light = shade.value;
  const [low, high] = elevations.value;
  if (!layers.terrain.value || shownMap.value) return null;
  switch (shading.value) {
    case 'elevation':
      return <ScaleLegend title="Elevation, m" gradient={cssGradient(elevationRamp[light])} low={low} high={high} />;
    case 'slope':
      return <ScaleLegend title="Slope, degrees" gradient={cssGradient(slopeRamp[light])} low={0} high={70} />;
    case 'material':
      return (
        <KindsLegend title="Material" kinds={(model.value?.materials ?? []).map((name, k) => ({ name, colour: materialColour(k) }))} />
      );
    default:
      return null;
  }
}

export function SceneLegend() {
  return (
    <div class="legends">
      <PathLegend />
      <MapLegend />
      <GroundLegend />
    </div>
  );
}
