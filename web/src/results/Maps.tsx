// The maps of a run, one of which can be draped over the terrain.

import { fileAddress, results } from '../api/results';
import type { Run, RunMap } from '../api/types';
import { OverMap } from '../maps/OverMap';
import { drapedMap, drapedOpacity } from '../state/view';
import { numberText } from '../ui/format';
import { displayOf } from '../state/displayUnits';
import { useRemote } from './remote';
import { Waiting } from './Waiting';

function Row({ run, map }: { run: Run; map: RunMap }) {
  const { unit, per } = displayOf(map.unit);
  const isShown = drapedMap.value === map.name;
  return (
    <tr class={isShown ? 'chosen' : ''}>
      <th scope="row">
        <button class="button" aria-pressed={isShown} onClick={() => (drapedMap.value = isShown ? null : map.name)}>
          {map.name}
        </button>
      </th>
      <td class="words">{map.meaning}</td>
      <td class="number">{numberText(map.least / per)}</td>
      <td class="number">{numberText(map.most / per)}</td>
      <td>{unit}</td>
      <td>{map.source ?? 'all'}</td>
      <td>
        <a href={fileAddress(run.id, `maps/${map.name}.tif`)} download>
          GeoTIFF
        </a>
      </td>
    </tr>
  );
}

export function Maps({ run }: { run: Run }) {
  const answer = useRemote(run.id, String(run.done), (signal) => results.maps(run.id, signal));
  const maps = answer.value;
  if (!maps) return <Waiting of={answer} />;
  if (maps.length === 0)
    return <div class="empty">This run has no maps. Maps are made in 3D if they are selected under Output.</div>;
  return (
    <div class="tab-page">
      <div class="tab-tools">
        <span class="faint">Choose a map to drape it over the terrain.</span>
        <OverMap />
        <label class="choice">
          Opacity
          <input
            type="range"
            min="0.1"
            max="1"
            step="0.05"
            value={drapedOpacity.value}
            onInput={(event) => (drapedOpacity.value = Number(event.currentTarget.value))}
          />
        </label>
      </div>
      <div class="tab-block table-scroll" tabIndex={0} role="region" aria-label="Maps">
        <table>
          <thead>
            <tr>
              {['Map', 'Meaning', 'Minimum', 'Maximum', 'Unit', 'Source', 'File'].map((title) => (
                <th key={title} scope="col" class={title === 'Minimum' || title === 'Maximum' ? 'number' : ''}>
                  {title}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {maps.map((map) => (
              <Row key={map.name} run={run} map={map} />
            ))}
          </tbody>
        </table>
      </div>
    </div>
  );
}
