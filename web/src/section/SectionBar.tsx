// The row of controls above the section.

import type { RefObject } from 'preact';
import { PathChoices } from '../paths/PathChoices';
import { file } from '../state/document';
import { Popover } from '../view/Popover';
import { equalAxes, layerNames, layers } from '../view/settings';
import { zoomed } from './frame';
import { fit, frame } from './picture';

function zoom(factor: number) {
  const now = frame.value;
  if (now) frame.value = zoomed(now, factor, now.width / 2, now.height / 2);
}

/// The picture as it is seen, as a file.
function save(canvas: HTMLCanvasElement | null) {
  canvas?.toBlob((blob) => {
    if (!blob) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${(file.value ?? 'section').replace(/^.*\/|\.toml$/g, '')}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  });
}

export function SectionBar({ canvas }: { canvas: RefObject<HTMLCanvasElement> }) {
  return (
    <div class="view-bar" role="toolbar" aria-label="View">
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
      <Popover title="Layers">
        {(Object.keys(layers) as (keyof typeof layers)[]).map((name) => (
          <label key={name}>
            <input type="checkbox" checked={layers[name].value} onChange={(event) => (layers[name].value = event.currentTarget.checked)} />
            {layerNames[name]}
          </label>
        ))}
      </Popover>
      <button class="button" title="Save the picture as PNG" onClick={() => save(canvas.current)}>
        Picture
      </button>
    </div>
  );
}
