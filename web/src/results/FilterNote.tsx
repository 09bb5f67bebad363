import { filter, isFiltering, showAllRocks } from '../runs/filter';
import { counted } from '../units/numbers';

/// A note that a filter is active, with the number of rocks that pass if known, and a button to reset it.
export function FilterNote({ left, of }: { left?: number; of?: number }) {
  if (!isFiltering(filter.value)) return null;
  const { reasons, seeders, sources, barriers, releases, crossing, minEnergy_kJ, maxEnergy_kJ } = filter.value;
  const parts = [
    reasons?.join(' or '),
    seeders && `from ${seeders.join(' or ')}`,
    sources && `from ${sources.join(' or ')}`,
    barriers && `hit ${barriers.join(' or ')}`,
    releases && `from release place ${releases.map((number) => number + 1).join(' or ')}`,
    crossing && 'cross the asked line',
    minEnergy_kJ !== null && `maximum total kinetic energy at least ${minEnergy_kJ} kJ`,
    maxEnergy_kJ !== null && `maximum total kinetic energy at most ${maxEnergy_kJ} kJ`,
  ];
  return (
    <span class="mark filter-note">
      {left !== undefined && of !== undefined ? `${left.toLocaleString('en')} of ${counted(of, 'rock')}` : 'Only rocks'}
      : {parts.filter(Boolean).join('; ')}
      <button class="button plain" onClick={showAllRocks}>
        All rocks
      </button>
    </span>
  );
}
