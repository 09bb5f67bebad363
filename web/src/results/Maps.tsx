// The maps of a run, one of which can be draped over the terrain.

import { fileAddress, results } from '../api/results';
import type { Run, RunMap } from '../api/types';
import { OverMap } from '../maps/OverMap';
import { drape, drapedMap, drapedOpacity, setOpacity } from '../maps/shownMap';
import { numberText } from '../units/numbers';
import { displayOf } from '../state/displayUnits';
import { capital, mapGroups, type MapGroup } from './mapGroups';
import { useRemote } from '../ui/remote';
import { Waiting } from '../ui/Waiting';

const rangeOf = ({ least, most, unit }: RunMap) => {
  const { unit: shown, per } = displayOf(unit);
  return `${numberText(least / per)} to ${numberText(most / per)} ${shown}`.trim();
};

function Group({ of: { title, unit, source, maps }, hasSources }: { of: MapGroup; hasSources: boolean }) {
  const { unit: shown } = displayOf(unit);
  return (
    <tr>
      <th scope="row">
        {title}
        {shown && `, ${shown}`}
      </th>
      {hasSources && <td>{source ?? 'all'}</td>}
      <td class="words">
        <div class="map-choices" role="group" aria-label={source === null ? title : `${title}, ${source}`}>
          {maps.map(({ map, part }) => {
            const isShown = drapedMap.value === map.name;
            return (
              <button key={map.name} class="button" aria-pressed={isShown} title={`${rangeOf(map)}; ${map.name}.tif`} onClick={() => drape(isShown ? null : map.name)}>
                {part}
              </button>
            );
          })}
        </div>
      </td>
    </tr>
  );
}

/// The range and the file of the draped map.
function Draped({ run, map }: { run: Run; map: RunMap }) {
  return (
    <span>
      <strong>{capital(map.meaning)}</strong>, {rangeOf(map)}:{' '}
      <a href={fileAddress(run.id, `maps/${map.name}.tif`)} download>
        {map.name}.tif
      </a>
    </span>
  );
}

export function Maps({ run }: { run: Run }) {
  const answer = useRemote(run.id, String(run.done), (signal) => results.maps(run.id, signal));
  const maps = answer.value;
  if (!maps) return <Waiting of={answer} />;
  if (maps.length === 0)
    return <div class="empty">This run has no maps. Maps are made in 3D if they are selected under Output.</div>;
  const draped = maps.find(({ name }) => name === drapedMap.value);
  const hasSources = maps.some(({ source }) => source !== null);
  return (
    <div class="tab-page">
      <div class="tab-tools">
        {draped ? <Draped run={run} map={draped} /> : <span class="faint">Choose a map to drape it over the terrain.</span>}
        <OverMap />
        <label class="choice">
          Opacity
          <input
            type="range"
            min="0.1"
            max="1"
            step="0.05"
            value={drapedOpacity.value}
            onInput={(event) => setOpacity(Number(event.currentTarget.value))}
          />
        </label>
      </div>
      <div class="tab-block table-scroll" tabIndex={0} role="region" aria-label="Maps">
        <table>
          <thead>
            <tr>
              {['Quantity', ...(hasSources ? ['Source'] : []), 'Maps'].map((title) => (
                <th key={title} scope="col">
                  {title}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {mapGroups(maps).map((group) => (
              <Group key={`${group.title} ${group.source ?? ''}`} of={group} hasSources={hasSources} />
            ))}
          </tbody>
        </table>
      </div>
    </div>
  );
}
