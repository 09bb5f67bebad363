// The toolbar of the scene.

import { AnimationButton } from '../animation/AnimationButton';
import { contours, exaggeration, setContours, setExaggeration, setShading, shading, type Shading } from '../view/settings';
import { AskButton } from '../askLine/AskButton';
import { FilterChoices } from '../paths/FilterChoices';
import { PathChoices } from '../paths/PathChoices';
import { SectionButton } from '../sectionLine/SectionButton';
import { DistanceButton } from '../tools/DistanceButton';
import { LayerChoices } from '../layers/LayerChoices';
import { Popover } from '../ui/Popover';
import { saveSheet } from '../view/sheet';
import { ViewBar } from '../view/ViewBar';
import { namedViews, type NamedView } from './namedViews';
import type { OpenScene } from './open';

const shadings: Record<Shading, string> = {
  elevation: 'Elevation',
  hillshade: 'Hillshade',
  slope: 'Slope',
  material: 'Material',
};
const stretches = [1, 1.5, 2, 3, 5];

export function SceneBar({ open }: { open: OpenScene }) {
  return (
    <ViewBar>
      <Popover title="View">
        {(Object.keys(namedViews) as NamedView[]).map((name) => (
          <button key={name} class="button plain" onClick={() => open.scene.view(name)}>
            <span>{namedViews[name].title}</span>
            <kbd>{namedViews[name].key}</kbd>
          </button>
        ))}
      </Popover>
      <Popover title="Terrain">
        <fieldset>
          <legend>Shaded by</legend>
          {(Object.keys(shadings) as Shading[]).map((how) => (
            <label key={how}>
              <input type="radio" name="shading" checked={shading.value === how} onChange={() => setShading(how)} />
              {shadings[how]}
            </label>
          ))}
        </fieldset>
        <label>
          <input type="checkbox" checked={contours.value} onChange={(event) => setContours(event.currentTarget.checked)} />
          Contour lines
        </label>
        <label>
          Vertical exaggeration
          <select value={exaggeration.value} onChange={(event) => setExaggeration(Number(event.currentTarget.value))}>
            {stretches.map((factor) => (
              <option key={factor} value={factor}>
                {factor}
              </option>
            ))}
          </select>
        </label>
      </Popover>
      <PathChoices />
      <FilterChoices />
      <LayerChoices memory={open.memory} />
      <DistanceButton />
      <AskButton />
      <SectionButton />
      <button
        class="button"
        title="Save the picture for print: PNG, 300 dpi"
        onClick={() => void saveSheet()}
      >
        Picture
      </button>
      <AnimationButton view={open.animated} />
    </ViewBar>
  );
}
