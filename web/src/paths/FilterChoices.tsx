// Which rocks are looked at, in a small panel of each view's bar.

import { everyRock, filter, isFiltering, type RockFilter } from '../state/filter';
import { Popover } from '../view/Popover';
import { shownPaths } from './drawnPaths';

type ListKey = 'reasons' | 'seeders' | 'sources' | 'barriers';
const titles: Record<ListKey, string> = { reasons: 'Ended', seeders: 'Seeder', sources: 'Source', barriers: 'Hit' };

/// A name is taken in or out; all of them are no condition, nor is none for barriers.
function toggled(key: ListKey, all: string[], name: string): RockFilter {
  const now = filter.value;
  const isOfHits = key === 'barriers';
  const chosen = now[key] ?? (isOfHits ? [] : all);
  const next = chosen.includes(name) ? chosen.filter((other) => other !== name) : all.filter((other) => other === name || chosen.includes(other));
  const isEvery = isOfHits ? next.length === 0 : next.length === all.length;
  return { ...now, [key]: isEvery ? null : next };
}

function Names({ of, names }: { of: ListKey; names: string[] }) {
  const all = [...new Set(names)];
  if (all.length === 0 || (all.length === 1 && of !== 'barriers')) return null;
  const isChosen = (name: string) => filter.value[of]?.includes(name) ?? of !== 'barriers';
  return (
    <fieldset>
      <legend>{titles[of]}</legend>
      {all.slice(0, 30).map((name) => (
        <label key={name}>
          <input type="checkbox" checked={isChosen(name)} onChange={() => (filter.value = toggled(of, all, name))} />
          {name}
        </label>
      ))}
    </fieldset>
  );
}

function Energy({ of, title }: { of: 'minEnergy_kJ' | 'maxEnergy_kJ'; title: string }) {
  return (
    <label>
      {title}
      <input
        type="number"
        min={0}
        step="any"
        style={{ width: '7em' }}
        value={filter.value[of] ?? ''}
        onChange={(event) => {
          const value = event.currentTarget.valueAsNumber;
          filter.value = { ...filter.value, [of]: Number.isNaN(value) ? null : value };
        }}
      />
      kJ
    </label>
  );
}

export function FilterChoices() {
  const paths = shownPaths.value;
  if (!paths) return null;
  const { reasons, seeders, sources, barriers } = paths.header;
  const ended = reasons.filter((_, k) => paths.reasons.includes(k));
  return (
    <Popover title={isFiltering(filter.value) ? 'Filter (on)' : 'Filter'}>
      <Names of="reasons" names={ended} />
      <Names of="seeders" names={seeders} />
      <Names of="sources" names={sources} />
      <Names of="barriers" names={barriers} />
      <fieldset>
        <legend>Greatest kinetic energy</legend>
        <Energy of="minEnergy_kJ" title="At least" />
        <Energy of="maxEnergy_kJ" title="At most" />
      </fieldset>
      <button class="button" disabled={!isFiltering(filter.value)} onClick={() => (filter.value = everyRock)}>
        All rocks
      </button>
    </Popover>
  );
}
