import type { Statistics } from '../api/types';
import { counted } from '../units/numbers';

/// A note that the results are of a sample of the rocks, with the setting as tooltip.
export function SampleNote({ of: { sample } }: { of: Pick<Statistics, 'sample'> }) {
  if (!sample) return null;
  return (
    <span class="mark" title="Setting output.endpoints">
      A sample of {sample.rocks.toLocaleString('en')} of {counted(sample.of, 'rock')}
    </span>
  );
}
