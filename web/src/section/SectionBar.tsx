// The toolbar of the section.

import { AnimationButton } from '../animation/AnimationButton';
import { AskButton } from '../askLine/AskButton';
import { FilterChoices } from '../paths/FilterChoices';
import { PathChoices } from '../paths/PathChoices';
import { SlopeButton } from '../slopeTools/SlopeButton';
import { saveSheet } from '../view/sheet';
import { DistanceButton } from '../tools/DistanceButton';
import { LayerChoices } from '../layers/LayerChoices';
import { equalAxes, setEqualAxes } from '../view/settings';
import { ViewBar } from '../view/ViewBar';
import { fit, zoomBy } from './framed';
import { animatedSection } from './sectionPrint';

/// A section is drawn from what the page holds anyway.
const memory = () => ({});

export function SectionBar() {
  return (
    <ViewBar>
      <button class="button" title="Show all (0)" onClick={fit}>
        Fit
      </button>
      <button class="button icon" aria-label="Zoom in" title="Zoom in (+)" onClick={() => zoomBy(1.25)}>
        +
      </button>
      <button class="button icon" aria-label="Zoom out" title="Zoom out (−)" onClick={() => zoomBy(0.8)}>
        −
      </button>
      <button class="button" aria-pressed={equalAxes.value} title="The same scale on both axes" onClick={() => setEqualAxes(!equalAxes.value)}>
        Equal axes
      </button>
      <PathChoices />
      <FilterChoices />
      <LayerChoices memory={memory} />
      <DistanceButton />
      <AskButton />
      <SlopeButton />
      <button class="button" title="Save the picture for print: PNG, 300 dpi" onClick={() => void saveSheet()}>
        Picture
      </button>
      <AnimationButton view={animatedSection} />
    </ViewBar>
  );
}
