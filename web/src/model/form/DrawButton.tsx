import { model } from '../../state/model';
import type { Path } from '../names';
import { drawable } from '../geometryTools';

/// Starts the drawing of a setting in the view.
export function DrawButton({ path }: { path: Path }) {
  const drawing = drawable(path);
  if (!drawing) return null;
  // A section can be begun on empty paper; anything else needs ground to point at.
  const isPossible = model.value !== null || path[0] === 'terrain';
  return (
    <button
      class="button"
      disabled={!isPossible}
      title={isPossible ? undefined : 'There is no terrain to point at yet'}
      onClick={drawing.start}
    >
      {drawing.title}
    </button>
  );
}
