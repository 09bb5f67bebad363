// Which line is answered for: the asked one, or a barrier or collector of the run.

import { ask, asked } from '../askLine/asked';
import { drawAsked } from '../askLine/askTools';
import { placeName } from '../askLine/shape';
import { shown } from '../runs/runs';
import { place, runBarriers } from './place';

export function PlaceChoice() {
  const [run, now, list] = [shown.value!, place.value, runBarriers.value];
  const drawn = asked.value && asked.value.kind !== 'barrier' ? asked.value : null;
  if (!now) return null;
  const names = list.map(({ name }) => name);
  const value = now.kind === 'barrier' ? `barrier ${now.name}` : 'drawn';
  const choose = (chosen: string) => {
    if (chosen === 'draw') drawAsked('line');
    else if (chosen.startsWith('barrier ')) ask({ kind: 'barrier', name: chosen.slice('barrier '.length) }, `ask ${chosen.slice('barrier '.length)}`, false);
  };
  return (
    <label class="place-choice">
      at
      <select
        aria-label="Place of the answers"
        value={value}
        onChange={(event) => {
          choose(event.currentTarget.value);
          event.currentTarget.value = value;
        }}
      >
        {drawn && <option value="drawn">{placeName(drawn, run.dimension)}</option>}
        {now.kind === 'barrier' && !names.includes(now.name) && <option value={value}>{now.name}</option>}
        {names.map((name) => (
          <option key={name} value={`barrier ${name}`}>
            {name}
          </option>
        ))}
        <option value="draw">{run.dimension === 2 ? 'Pick another place…' : 'Draw another line…'}</option>
      </select>
    </label>
  );
}
