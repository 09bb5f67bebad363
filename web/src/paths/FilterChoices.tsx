// The rock filter, in a popover of each view's toolbar.

import { useState } from 'preact/hooks';
import { filter, filterBy, isFiltering, showAllRocks } from '../runs/filter';
import type { RockFilter } from '../api/results';
import { counted } from '../units/numbers';
import { Popover } from '../ui/Popover';
import { shownPaths } from './drawnPaths';
import { leftByFilter } from './shownPassing';

type ListKey = 'reasons' | 'seeders' | 'sources' | 'barriers';
const titles: Record<ListKey, string> = {
  reasons: 'End reason',
  seeders: 'Seeder',
  sources: 'Source',
  barriers: 'Barrier hit',
};

/// Adds or removes a name. All names, or no barrier, are the same as no condition.
function toggled(key: ListKey, all: string[], name: string): Partial<RockFilter> {
  const isOfHits = key === 'barriers';
  const chosen = filter.peek()[key] ?? (isOfHits ? [] : all);
  const next = chosen.includes(name) ? chosen.filter((other) => other !== name) : all.filter((other) => other === name || chosen.includes(other));
  const isEvery = isOfHits ? next.length === 0 : next.length === all.length;
  return { [key]: isEvery ? null : next };
}

const mostWithoutSearch = 12; // longer lists have a search field
const mostRows = 500;

function Names({ of, names }: { of: ListKey; names: string[] }) {
  const [wanted, setWanted] = useState('');
  const all = [...new Set(names)];
  if (all.length === 0 || (all.length === 1 && of !== 'barriers')) return null;
  const chosen = filter.value[of] && new Set(filter.value[of]);
  const isChosen = (name: string) => chosen?.has(name) ?? of !== 'barriers';
  const found = all.filter((name) => name.toLowerCase().includes(wanted.trim().toLowerCase()));
  return (
    <fieldset>
      <legend>{titles[of]}</legend>
      {all.length > mostWithoutSearch && (
        <input
          type="search"
          aria-label={`Search ${titles[of].toLowerCase()}`}
          placeholder={`Search ${all.length.toLocaleString('en')}`}
          value={wanted}
          onInput={(event) => setWanted(event.currentTarget.value)}
        />
      )}
      <div class="names">
        {found.slice(0, mostRows).map((name) => (
          <label key={name} title={name}>
            <input type="checkbox" checked={isChosen(name)} onChange={() => filterBy(toggled(of, all, name))} />
            <span>{name}</span>
          </label>
        ))}
      </div>
      {found.length > mostRows && (
        <span class="faint">The first {mostRows} of {counted(found.length, 'name')}. Search to find others.</span>
      )}
      {found.length === 0 && <span class="faint">No such name.</span>}
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
          filterBy({ [of]: Number.isNaN(value) ? null : value });
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
  const count = leftByFilter.value;
  const left = count && `${count.left.toLocaleString('en')} of ${count.of.toLocaleString('en')}`;
  return (
    <Popover title={left ? `Filter: ${left}` : 'Filter'}>
      <Names of="reasons" names={ended} />
      <Names of="seeders" names={seeders} />
      <Names of="sources" names={sources} />
      <Names of="barriers" names={barriers} />
      <fieldset>
        <legend>Maximum total kinetic energy</legend>
        <Energy of="minEnergy_kJ" title="At least" />
        <Energy of="maxEnergy_kJ" title="At most" />
      </fieldset>
      <button class="button" disabled={!isFiltering(filter.value)} onClick={() => showAllRocks()}>
        All rocks
      </button>
    </Popover>
  );
}
