// Whether the rocks are enough for narrow intervals, and how many would do.

import type { Enough } from '../api/line';
import { compute } from '../runs/runs';

export function EnoughRocks({ of: { text, rocks } }: { of: Enough }) {
  if (text === '') return null;
  return (
    <div class="problem warning asked-enough">
      {text}
      {rocks !== null && (
        <button class="button" onClick={() => void compute({ rocks })}>
          Run {rocks.toLocaleString('en')} rocks
        </button>
      )}
    </div>
  );
}
