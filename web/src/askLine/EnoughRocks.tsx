// Whether the rocks are enough for narrow intervals, and how many would do.

import type { AskedAnswer } from '../api/line';
import { compute } from '../runs/runs';
import { enoughText } from './enoughText';

export function EnoughRocks({ of }: { of: AskedAnswer }) {
  const text = enoughText(of);
  if (text === '') return null;
  const { rocks } = of.enough;
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
