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
import { zoomed } from './frame';
import { fit, frame } from './framed';
import { animatedSection } from './sectionPrint';

/// A section is drawn from what the page holds anyway.
const memory = () => ({});

function zoom(factor: number) {
  const now = frame.value;
  if (now) frame.value = zoomed(now, factor, now.width / 2, now.height / 2);
}

export function SectionBar() {
  return (
    <ViewBar>
      <button class="button" title="Show all (0)" onClick={fit}>
        Fit
      </button>
      <button class="button icon" aria-label="Zoom in" title="Zoom in (+)" onClick={() => zoom(1.25)}>
        +
      </button>
      <button class="button icon" aria-label="Zoom out" title="Zoom out (−)" onClick={() => zoom(0.8)}>
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
