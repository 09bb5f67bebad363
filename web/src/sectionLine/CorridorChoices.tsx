// What a ground section has besides the ground: the width of its corridor, and its envelope.

import { filter, isFiltering } from '../runs/filter';
import { displayOf } from '../state/displayUnits';
import { counted } from '../units/numbers';
import { corridorWidth, sectionEnvelope, setCorridorWidth, showEnvelope, type SectionEnvelope } from './corridorSettings';
import { corridorPaths, drawnCount } from './corridorTraces';
import { envelopeChoices } from './stations';

export function CorridorChoices() {
  const found = corridorPaths.value;
  const count = found?.rockCount ?? 0;
  const drawn = drawnCount.value;
  return (
    <>
      <label class="choice" title="Trajectories at most this far from the line, on both sides, are drawn">
        Corridor ±
        <input
          type="number"
          aria-label="Half width of the corridor [m]"
          min={0.1}
          step="any"
          value={corridorWidth.value}
          onChange={(event) => {
            const value = event.currentTarget.valueAsNumber;
            if (value > 0) setCorridorWidth(value);
            else event.currentTarget.value = String(corridorWidth.value);
          }}
        />
        m
      </label>
      <label class="choice">
        Envelope
        <select
          value={sectionEnvelope.value}
          onChange={(event) => showEnvelope(event.currentTarget.value as SectionEnvelope)}
        >
          <option value="">none</option>
          {Object.entries(envelopeChoices).map(([key, { title, unit }]) => (
            <option key={key} value={key}>
              {title} [{displayOf(unit).unit}]
            </option>
          ))}
        </select>
      </label>
      <span class="faint" role="status">
        {drawn < count ? `${drawn.toLocaleString('en')} of ` : ''}
        {counted(count, 'trajectory', 'trajectories')}
        {sectionEnvelope.value !== '' && isFiltering(filter.value) && '; envelope of all rocks'}
      </span>
    </>
  );
}
