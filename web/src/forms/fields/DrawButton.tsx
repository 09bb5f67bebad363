import { model } from '../../project/model';
import type { Path } from '../../settings/names';
import { drawable } from '../../tools/geometryTools';

/// Starts drawing a setting in the view.
export function DrawButton({ path }: { path: Path }) {
  const drawing = drawable(path);
  if (!drawing) return null;
  // A section can be drawn on an empty view; everything else needs terrain.
  const isPossible = model.value !== null || path[0] === 'terrain';
  return (
    <button
      class="button"
      disabled={!isPossible}
      title={isPossible ? undefined : 'There is no terrain to click on yet'}
      onClick={drawing.start}
    >
      {drawing.title}
    </button>
  );
}
