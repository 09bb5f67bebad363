// The legends of the scene.

import { sourceLegends } from '../askLine/sources';
import { observedLegends } from '../calibration/observations';
import { hidesGround } from '../layers/draped';
import { isDrawn, layerLegends, projectLayers } from '../layers/layers';
import { mapLegends } from '../maps/mapLegends';
import { shownMap } from '../maps/shownMap';
import { pathLegends } from '../paths/pathLegends';
import { model } from '../project/model';
import { elevationRamp, materialColour, slopeRamp } from '../view/colours';
import { Legends } from '../view/Legend';
import { stopsOf, type LegendData } from '../view/legends';
import { layers, shading } from '../view/settings';
import { shade } from '../view/theme';
import { elevations } from './picture';

function groundLegends(): LegendData[] {
  const light = shade.value;
  const [low, high] = elevations.value;
  if (!layers.terrain.value || shownMap.value) return [];
  if (model.value && hidesGround(projectLayers.value.filter(isDrawn), model.value.bounds)) return [];
  const scale = { kind: 'scale', isClipped: false } as const;
  switch (shading.value) {
    case 'elevation':
      return [{ ...scale, title: 'Elevation, m', stops: stopsOf(elevationRamp[light]), low, high }];
    case 'slope':
      return [{ ...scale, title: 'Slope, degrees', stops: stopsOf(slopeRamp[light]), low: 0, high: 70 }];
    case 'material':
      return [{ kind: 'kinds', title: 'Material', kinds: (model.value?.materials ?? []).map((name, k) => ({ name, colour: materialColour(k) })) }];
    default:
      return [];
  }
}

export const sceneLegends = (): LegendData[] => [...pathLegends(), ...sourceLegends(), ...observedLegends(), ...mapLegends(), ...layerLegends(), ...groundLegends()];

export const SceneLegend = () => <Legends list={sceneLegends()} />;
