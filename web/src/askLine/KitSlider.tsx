// A kit at the line: its height and capacity, and what it would stop, from the table of the answer.

import type { KitTable } from '../api/line';
import { numberText } from '../units/numbers';
import { kitEnergy, kitHeight, setKitEnergy, setKitHeight } from './asked';
import { kitSentence, kitShare, nearestIndex } from './kit';

interface SliderProps {
  title: string;
  unit: string;
  values: readonly number[];
  at: number;
  choose: (value: number) => void;
}

function Slider({ title, unit, values, at, choose }: SliderProps) {
  const text = `${numberText(values[at]!)} ${unit}`;
  return (
    <label class="kit-slider">
      <span>{title}</span>
      <input
        type="range"
        min="0"
        max={values.length - 1}
        step="1"
        value={at}
        aria-label={title}
        aria-valuetext={text}
        onInput={(event) => choose(values[Number(event.currentTarget.value)]!)}
      />
      <output class="mono">{text}</output>
    </label>
  );
}

export function KitSlider({ of }: { of: KitTable }) {
  const [height, energy] = [nearestIndex(of.heights_m, kitHeight.value), nearestIndex(of.energies_kJ, kitEnergy.value)];
  const kit = kitShare(of, height, energy);
  return (
    <div class="asked-kit">
      <h3>A kit here</h3>
      <Slider title="Height" unit="m" values={of.heights_m} at={height} choose={setKitHeight} />
      <Slider title="Capacity" unit="kJ" values={of.energies_kJ} at={energy} choose={setKitEnergy} />
      {kit && (
        <p class="kit-sentence" aria-live="polite">
          {kitSentence(kit)}
        </p>
      )}
    </div>
  );
}
