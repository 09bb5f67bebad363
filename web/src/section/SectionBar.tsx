// The row of controls above the section.

import { FilterChoices } from '../paths/FilterChoices';
import { PathChoices } from '../paths/PathChoices';
import { saveSheet } from '../view/sheet';
import { DistanceButton } from '../view/DistanceButton';
import { LayerChoices } from '../view/LayerChoices';
import { equalAxes } from '../view/settings';
import { ViewBar } from '../view/ViewBar';
import { zoomed } from './frame';
import { fit, frame } from './framed';
import { sectionPicture } from './sectionPrint';

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
      <button class="button icon" aria-label="Larger" title="Larger (+)" onClick={() => zoom(1.25)}>
        +
      </button>
      <button class="button icon" aria-label="Smaller" title="Smaller (−)" onClick={() => zoom(0.8)}>
        −
      </button>
      <button class="button" aria-pressed={equalAxes.value} title="One metre up is as long as one metre along" onClick={() => (equalAxes.value = !equalAxes.value)}>
        Equal axes
      </button>
      <PathChoices />
      <FilterChoices />
      <LayerChoices />
      <DistanceButton />
      <button class="button" title="Save the picture for print: PNG, 300 dots an inch" onClick={() => void saveSheet(sectionPicture)}>
        Picture
      </button>
    </ViewBar>
  );
}
